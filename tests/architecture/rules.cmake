# Who may include whom (docs/architecture.md), as data. A row per folder: the folders of ours it may include besides itself, and the
# libraries that have a place in it. The longest matching row counts, so a row may also name one file. A folder without a row is an error.
#
# model/base is the common ground (ids, points, Result, parallelFor) below everything; tri/ sees it and nothing else of model/.
set(architecture_rows
    # folder          | may include                                                        | libraries
    "model/base       |                                                                    |"
    "model            | model/base                                                         |"
    "model/generate   | model/base                                                         |"
    "model/odb        | model model/base                                                   |"
    "model/paper      | model model/base                                                   |"
    "model/session    | model model/base                                                   |"
    "model/reader.cpp | model model/base model/odb model/paper                             |"
    "tri              | model/base                                                         |"
    "tri/gpu          | model/base tri render/gpu shaders                                  | vulkan"
    "tri/bench        | model/base tri tri/gpu render/gpu                                  |"
    "shaders          |                                                                    |"
    "render/gpu       | model/base shaders                                                 | vulkan"
    "render           | model model/base tri render/gpu shaders                            | vulkan"
    "ui/models        | model model/base model/session render/layer_style.h                | qt"
    "ui               | model model/base model/session ui/models render render/gpu                  | qt widgets vulkan"
    "app              | model model/base model/session model/generate model/odb model/paper tri tri/gpu tri/bench render render/gpu ui ui/models | qt widgets vulkan"
    "tests            | model model/base model/session model/generate model/odb model/paper tri tri/gpu tri/bench shaders render render/gpu ui ui/models app | qt widgets vulkan"
)

# How an include of a library is told from its name.
set(architecture_library_qt "^(Qt[A-Z][A-Za-z]*(/.*)?|Q[A-Z][A-Za-z0-9]*|q[a-z0-9]+\\.h)$")
set(architecture_library_vulkan "^vulkan/")
set(architecture_library_widgets
    "^QtWidgets|Q(Application|MainWindow|DesktopWidget|Label|Menu|MenuBar|ToolBar|StatusBar|Slider|Splitter|Frame|Completer|ProgressBar)$|^Q[A-Za-z]*(Widget|View|Layout|Button|Dialog|Box|Edit|Delegate|Style|Area|Bar)$")
