# cmake -DWORK=<scratch folder> -P vocabulary_catches_violations.cmake
# Plants one word after the other in a small tree: vocabulary.cmake must name each forbidden one and accept each allowed one.
cmake_minimum_required(VERSION 3.25)

set(cases
    "bad  | model/board/a.cpp           | text = \"The lacquer is green.\","
    "bad  | ui/layers/a.cpp             | tr(\"Forget\")"
    "bad  | ui/layers/a.cpp             | tr(\"Light up the net\")"
    "bad  | app/commands/a.cpp          | \"two things of a board\""
    "bad  | render/frame/a.cpp          | \"say \\\"stack\\\" here\""
    "bad  | app/reports/a.cpp           | \"Narrowest places\""
    "bad  | ui/views/a.cpp              | \"Cut open\""
    "bad  | model/board/a.cpp           | int laminateHeight = 0"
    "bad  | tri/a.h                     | void keptViews()"
    "bad  | shaders/a.glsl              | float lacquer = 1.0"
    "bad  | README.md                   | The gap at the cursor."
    "bad  | docs/a.md                   | Remarks are printed."
    "good | model/board/a.cpp           | // the lacquer of a comment is for reviews"
    "good | model/board/a.cpp           | json(\"gap_um\") = overcoat.stackup"
    "good | model/export/a.cpp          | \"<path stroke=\\\"#000\\\"/>\""
    "good | app/commands/measure_command.cpp | json(\"remarks\")"
    "good | ui/layers/a.cpp             | tr(\"Floating copper under the solder mask\")"
    "good | tests/ui/a.cpp              | \"lacquer\""
    "good | docs/decisions/a.md         | The lacquer of old decisions stays."
)

foreach(case_text IN LISTS cases)
    string(REGEX MATCH "^(bad|good) *\\| *([^ ]*) *\\| *(.*)$" case_text "${case_text}")
    set(verdict ${CMAKE_MATCH_1})
    set(file ${CMAKE_MATCH_2})
    file(REMOVE_RECURSE ${WORK})
    file(WRITE ${WORK}/${file} "#include \"coat.h\"\n${CMAKE_MATCH_3}\n")
    execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK} -P ${CMAKE_CURRENT_LIST_DIR}/vocabulary.cmake
                    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
    string(FIND "${said}" "${file}" named)
    if(verdict STREQUAL bad AND (code EQUAL 0 OR named EQUAL -1))
        message(SEND_ERROR "not caught: ${case_text}\n${said}")
    elseif(verdict STREQUAL good AND NOT code EQUAL 0)
        message(SEND_ERROR "wrongly refused: ${case_text}\n${said}")
    endif()
endforeach()
file(REMOVE_RECURSE ${WORK})
