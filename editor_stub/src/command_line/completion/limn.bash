_limn()
{
    local words=() word typed line i
    for ((i = 1; i <= COMP_CWORD; i++)); do
        word=${COMP_WORDS[i]}
        [[ $word == [\"\']* ]] && word=${word:1}
        word=${word//\\/}
        if ((i > 1)) && [[ ${COMP_WORDS[i]} == [=:]* || ${COMP_WORDS[i - 1]} == *[=:] ]]; then
            words[${#words[@]} - 1]+=$word
        else
            words+=("$word")
        fi
    done
    typed=$word
    [[ $typed == [=:]* ]] && typed=
    local before=${words[${#words[@]} - 1]%"$typed"}
    local limn=${BASH_ALIASES[${COMP_WORDS[0]}]:-${COMP_WORDS[0]}}
    limn=${limn/#\~/$HOME}
    COMPREPLY=()
    while IFS= read -r line; do
        line=${line%%$'\t'*}
        line=${line#"$before"}
        [[ ${COMP_WORDS[COMP_CWORD]} == [\"\']* || $line != *[\ \'\"\(\)\&]* ]] ||
            printf -v line %q "$line"
        COMPREPLY+=("$line")
    done < <("$limn" complete -- "${words[@]}" 2>/dev/null)
    # A folder, a component and a parameter go on.
    [[ ${#COMPREPLY[@]} != 1 || $COMPREPLY != *[/.=] ]] || compopt -o nospace 2>/dev/null
}
complete -o default -F _limn limn
