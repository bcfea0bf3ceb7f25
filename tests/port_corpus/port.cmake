# Ports each C# file of the corpus by `limn port` into a folder of its own. What did not change keeps
# its time, so that it is compiled again only where `limn port` writes something else.
# cmake -DLIMN=... -DFILES="a.cs;b.cs" -DFOLDER=... -P port.cmake
foreach(csharp ${FILES})
    cmake_path(GET csharp STEM name)
    set(new ${FOLDER}/new/${name})
    file(REMOVE_RECURSE ${new})
    execute_process(COMMAND ${LIMN} port ${csharp} -o ${new} -q
        RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "limn port ${csharp} ends with ${result}:\n${said}")
    endif()
    foreach(file ${name}.h ${name}.cpp)
        if(NOT EXISTS ${new}/${file})
            message(FATAL_ERROR "limn port ${csharp} writes no ${file}")
        endif()
        file(COPY_FILE ${new}/${file} ${FOLDER}/${name}/${file} ONLY_IF_DIFFERENT)
    endforeach()
endforeach()
