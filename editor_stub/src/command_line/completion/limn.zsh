#compdef limn
_limn()
{
    local -a lines ends opens
    local line
    lines=("${(@f)$("${(Q)words[1]/#\~/$HOME}" complete -- "${(@Q)words[2,CURRENT]}" 2>/dev/null)}")
    for line in $lines; do
        # A folder, a component and a parameter go on.
        case $line in
            *[/.=]) opens+=("$line") ;;
            *$'\t'*) ends+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}") ;;
            *) ends+=("${line//:/\\:}") ;;
        esac
    done
    if (( $#ends + $#opens == 0 )); then
        _files
        return
    fi
    (( $#opens )) && compadd -S '' -a opens
    (( $#ends )) && _describe value ends
}
# It is sourced, or it is the body of a function that zsh loads at the first Tab.
if [ "$funcstack[1]" = _limn ]; then _limn; else compdef _limn limn; fi
