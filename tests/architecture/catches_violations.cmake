# cmake -DWORK=<scratch folder> -P catches_violations.cmake
# Plants one include or namespace after the other in a small tree that keeps to the rules, then a folder and a file that are too large, an
# algorithm that not all compilers know and a cycle: check_includes.cmake must name each forbidden one and accept each allowed one, else it proves nothing.
cmake_minimum_required(VERSION 3.25)

set(cases
    # verdict | file                        | include or line
    "bad  | model/base/a.h                  | \"model/board/document.h\""
    "bad  | model/board/a.cpp               | \"render/scene/board_scene.h\""
    "bad  | model/board/a.cpp               | \"ui/shell/main_window.h\""
    "bad  | model/board/a.cpp               | \"model/formats/common/archive.h\""
    "bad  | model/geometry/a.cpp            | \"model/board/document.h\""
    "bad  | model/board/a.cpp               | <QString>"
    "bad  | model/board/a.h                 | <vulkan/vulkan.h>"
    "bad  | model/board/a.cpp               | <nlohmann/json.hpp>"
    "bad  | model/formats/common/a.cpp      | \"model/formats/odb/text/records.h\""
    "bad  | model/formats/odb/a.cpp         | <QtCore/QFile>"
    "bad  | model/formats/odb/a.cpp         | \"model/formats/paper/lexer.h\""
    "bad  | tri/a.cpp                       | \"model/board/document.h\""
    "bad  | tri/a.cpp                       | \"render/scene/board_scene.h\""
    "bad  | tri/a.cpp                       | <vulkan/vulkan_core.h>"
    "bad  | tri/a.cpp                       | \"tri/gpu/triangulator.h\""
    "bad  | tri/gpu/a.cpp                   | \"render/scene/board_scene.h\""
    "bad  | tri/gpu/a.cpp                   | \"model/board/document.h\""
    "bad  | render/frame/a.cpp              | \"ui/shell/main_window.h\""
    "bad  | render/scene/a.cpp              | \"render/frame/renderer.h\""
    "bad  | render/scene/a.cpp              | <QImage>"
    "bad  | render/scene/a.cpp              | <qvulkaninstance.h>"
    "bad  | render/gpu/a.cpp                | \"model/board/document.h\""
    "bad  | render/gpu/a.cpp                | \"render/scene/board_scene.h\""
    "bad  | shaders/shared/a.h              | \"model/base/ids.h\""
    "bad  | shaders/a.comp.glsl             | \"../model/board/document.h\""
    "bad  | shaders/a.cpp                   | \"nothing_vert.h\""
    "bad  | ui/layers/a.cpp                 | \"ui/shell/main_window.h\""
    "bad  | ui/layers/a.cpp                 | \"ui/nets/net_model.h\""
    "bad  | ui/shell/a.cpp                  | \"app/main.h\""
    "bad  | ui/shell/a.cpp                  | \"model/formats/common/archive.h\""
    "bad  | model/board/a.cpp               | \"document.h\""
    "bad  | model/board/a.cpp               | \"../board/document.h\""
    "bad  | gadgets/a.cpp                   | <vector>"
    "bad  | model/gadgets/a.cpp             | <vector>"
    "bad  | model/a.cpp                     | <vector>"
    "good | model/board/a.cpp               | <queue>"
    "good | model/board/a.cpp               | \"model/geometry/shapes.h\""
    "good | tri/a.cpp                       | \"model/base/point.h\""
    "good | tri/gpu/a.cpp                   | \"tri/triangulate.h\""
    "good | tri/gpu/a.cpp                   | \"render/gpu/device.h\""
    "good | tri/gpu/a.cpp                   | \"shaders/tri/forest.h\""
    "good | render/modelling/a.cpp          | \"shaders/shared/board.h\""
    "good | render/modelling/a.cpp          | \"tri/triangulate.h\""
    "good | shaders/shared/b.h              | \"b.h\""
    "good | render/gpu/a.cpp                | <vulkan/vulkan.h>"
    "good | ui/layers/a.cpp                 | <QAbstractTableModel>"
    "good | ui/shell/a.cpp                  | <QMainWindow>"
    "good | shaders/a.cpp                   | \"all_spirv.h\""
    "good | tests/ui/a.h                    | \"a.h\""
    "good | tests/ui/a.cpp                  | \"a.moc\""
    "bad  | model/board/a.cpp               | namespace ui {"
    "good | model/board/a.cpp               | namespace model {"
    "bad  | app/commands/a.cpp              | <dlfcn.h>"
    "good | app/verify/a.cpp                | <dlfcn.h>"
    "good | ui/layers/a.cpp                 | namespace ui {"
)

function(check case_text)
    string(REPLACE "|" ";" columns "${case_text}")
    list(TRANSFORM columns STRIP)
    list(GET columns 0 verdict)
    list(GET columns 1 file)
    list(GET columns 2 include)
    file(REMOVE_RECURSE ${WORK})
    file(WRITE ${WORK}/model/board/document.h "#include <vector>\n#include \"model/base/ids.h\"\n")
    if(NOT include MATCHES "^namespace")
        set(include "#  include ${include}  // planted")
    endif()
    file(WRITE ${WORK}/${file} "#include <string>\n${include}\n")
    expect(${verdict} ${file} "${file} has ${include}")
endfunction()

# Runs the check with more of its arguments in ARGN: `bad` must fail and name `name`.
function(expect verdict name what)
    execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK} ${ARGN} -P ${CMAKE_CURRENT_LIST_DIR}/check_includes.cmake
                    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
    string(FIND "${said}" "${name}" named)
    if(verdict STREQUAL bad AND (code EQUAL 0 OR named EQUAL -1))
        message(SEND_ERROR "not caught: ${what}\n${said}")
    elseif(verdict STREQUAL good AND NOT code EQUAL 0)
        message(SEND_ERROR "wrongly refused: ${what}\n${said}")
    endif()
endfunction()

foreach(case_text IN LISTS cases)
    check("${case_text}")
endforeach()

file(REMOVE_RECURSE ${WORK})
foreach(number RANGE 1 41)
    file(WRITE ${WORK}/model/board/a${number}.cpp "")
endforeach()
expect(bad "model/board has 41" "a folder of 41 sources")
file(REMOVE_RECURSE ${WORK})
string(REPEAT "\n" 601 lines)
file(WRITE ${WORK}/model/board/a.cpp "${lines}")
expect(bad "model/board/a.cpp has 601" "a file of 601 lines")
file(WRITE ${WORK}/model/board/a.cpp "rows.erase(std::ranges::unique(rows).begin(), rows.end());\n")
expect(bad "model/board/a.cpp" "an algorithm of ranges that clang 14 does not compile")
file(WRITE ${WORK}/model/board/a.cpp "rows.erase(std::unique(rows.begin(), rows.end()), rows.end());\n")
expect(good "model/board/a.cpp" "the same algorithm of std")
file(WRITE ${WORK}/model/board/a.cpp "")
file(WRITE ${WORK}/cycle.cmake "list(APPEND architecture_rows \"model/base | model | model/board |\" \"model/board | model | model/base |\")")
expect(bad "model/board" "a cycle" -DMORE_RULES=${WORK}/cycle.cmake)
file(REMOVE_RECURSE ${WORK})
