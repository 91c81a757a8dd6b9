# cmake -DWORK=<scratch folder> -P catches_violations.cmake
# Plants one include after the other in a small tree that keeps to the rules: check_includes.cmake must name each forbidden one and accept
# each allowed one, else it proves nothing.
cmake_minimum_required(VERSION 3.25)

set(cases
    # verdict | file                        | include
    "bad  | model/base/a.h                  | \"model/board/document.h\""
    "bad  | model/a.cpp                     | \"render/view.h\""
    "bad  | model/a.cpp                     | \"ui/shell/main_window.h\""
    "bad  | model/a.cpp                     | \"model/formats/common/archive.h\""
    "bad  | model/a.cpp                     | <QString>"
    "bad  | model/odb/a.cpp                 | <QtCore/QFile>"
    "bad  | model/odb/a.cpp                 | \"model/formats/paper/lexer.h\""
    "bad  | model/a.h                       | <vulkan/vulkan.h>"
    "bad  | tri/a.cpp                       | \"model/board/document.h\""
    "bad  | tri/a.cpp                       | \"render/view.h\""
    "bad  | tri/a.cpp                       | <vulkan/vulkan_core.h>"
    "bad  | tri/a.cpp                       | \"tri/gpu/triangulator.h\""
    "bad  | tri/gpu/a.cpp                   | \"render/view.h\""
    "bad  | tri/gpu/a.cpp                   | \"model/board/document.h\""
    "bad  | render/a.cpp                    | \"ui/shell/main_window.h\""
    "bad  | render/a.cpp                    | \"model/formats/common/archive.h\""
    "bad  | render/a.cpp                    | <QImage>"
    "bad  | render/a.cpp                    | <qvulkaninstance.h>"
    "bad  | render/gpu/a.cpp                | \"model/board/document.h\""
    "bad  | render/gpu/a.cpp                | \"render/view.h\""
    "bad  | shaders/shared/a.h              | \"model/base/ids.h\""
    "bad  | shaders/a.comp.glsl             | \"../model/document.h\""
    "bad  | shaders/a.cpp                   | \"nothing_vert.h\""
    "bad  | ui/models/a.cpp                 | <QWidget>"
    "bad  | ui/models/a.cpp                 | <QtWidgets/QTableView>"
    "bad  | ui/models/a.cpp                 | <QTableView>"
    "bad  | ui/models/a.cpp                 | \"render/view.h\""
    "bad  | ui/models/a.cpp                 | \"ui/shell/main_window.h\""
    "bad  | ui/a.cpp                        | \"app/main.h\""
    "bad  | ui/a.cpp                        | \"model/formats/common/archive.h\""
    "bad  | model/a.cpp                     | \"document.h\""
    "bad  | model/a.cpp                     | \"../model/document.h\""
    "bad  | gadgets/a.cpp                   | <vector>"
    "good | model/a.cpp                     | <queue>"
    "good | model/formats/registry.cpp                | \"model/formats/odb/odb_reader.h\""
    "good | tri/a.cpp                       | \"model/base/point.h\""
    "good | tri/gpu/a.cpp                   | \"tri/triangulate.h\""
    "good | tri/gpu/a.cpp                   | \"render/gpu/device.h\""
    "good | tri/gpu/a.cpp                   | \"shaders/tri/forest.h\""
    "good | render/a.cpp                    | \"shaders/shared/board.h\""
    "good | render/a.cpp                    | \"tri/triangulate.h\""
    "good | shaders/shared/b.h              | \"b.h\""
    "good | render/gpu/a.cpp                | <vulkan/vulkan.h>"
    "good | ui/models/a.cpp                 | \"render/scene/layer_style.h\""
    "good | ui/models/a.cpp                 | <QAbstractTableModel>"
    "good | ui/a.cpp                        | <QMainWindow>"
    "good | app/a.cpp                       | \"ui/shell/main_window.h\""
    "good | shaders/a.cpp                   | \"planted_vert.h\""
    "good | tests/ui/a.h                    | \"a.h\""
    "good | tests/ui/a.cpp                  | \"a.moc\""
)

function(check case_text)
    string(REPLACE "|" ";" columns "${case_text}")
    list(TRANSFORM columns STRIP)
    list(GET columns 0 verdict)
    list(GET columns 1 file)
    list(GET columns 2 include)
    file(REMOVE_RECURSE ${WORK})
    file(WRITE ${WORK}/model/document.h "#include <vector>\n#include \"model/base/ids.h\"\n")
    file(WRITE ${WORK}/shaders/planted.vert.glsl "")
    file(WRITE ${WORK}/${file} "#include <string>\n#  include ${include}  // planted\n")
    execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${WORK} -P ${CMAKE_CURRENT_LIST_DIR}/check_includes.cmake
                    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
    string(FIND "${said}" "${file}" named)
    if(verdict STREQUAL bad AND (code EQUAL 0 OR named EQUAL -1))
        message(SEND_ERROR "not caught: ${file} includes ${include}\n${said}")
    elseif(verdict STREQUAL good AND NOT code EQUAL 0)
        message(SEND_ERROR "wrongly refused: ${file} includes ${include}\n${said}")
    endif()
endfunction()

foreach(case_text IN LISTS cases)
    check("${case_text}")
endforeach()
file(REMOVE_RECURSE ${WORK})
