# The house as data (docs/architecture.md): a row per folder, which is one CMake target (copperscope_ and the path with _ for /).
# The build links targets by this table and the test `architecture` holds every include line against it, so there is one truth:
# the namespace of the folder's sources, the folders of ours it may include besides itself and (but for shaders) model/base, and the libraries that
# have a place in it. A folder without a row is an error, and so is a cycle.
#
# model/base is the common ground (ids, points, Result, parallelFor) below everything; tri/ sees it and nothing else of model/.
set(architecture_rows
    # folder                       | namespace       | may include | libraries
    "model/base                    | base model      | | tbb"
    "model/text                    | model           | | json zlib"
    "model/geometry                | model           | | clipper"
    "model/geometry/loops          | model           | model/geometry |"
    "model/board                   | model           | model/geometry |"
    "model/figures                 | model           | model/board model/geometry |"
    "model/index                   | model           | model/board model/figures model/geometry |"
    "model/packages                | model           | model/board model/formats/common model/geometry |"
    "model/solids                  | model           | model/board model/figures model/geometry model/packages |"
    "model/solids/shells           | model           | model/board model/geometry model/geometry/loops |"
    "model/statistics              | model           | model/board model/figures model/geometry |"
    "model/nets                    | model           | model/board model/figures model/geometry model/index model/statistics model/text |"
    "model/measure                 | model           | model/board model/clearance model/figures model/geometry model/index model/statistics model/text |"
    "model/clearance               | model           | model/board model/figures model/geometry model/index model/nets model/text | json"
    "model/design_rules            | model           | model/board model/clearance model/figures model/geometry model/nets model/solids model/text |"
    "model/section                 | model           | model/board model/figures model/geometry model/index model/measure model/packages model/text |"
    "model/agreement               | model           | model/board model/figures model/geometry model/text |"
    "model/export                  | model           | model/board model/clearance model/figures model/geometry model/index model/measure model/section model/text | json"
    "model/export/drawings         | model           | model/board model/geometry model/geometry/loops model/solids/shells model/text | zlib"
    "model/export/solids           | model           | model/board model/geometry model/geometry/loops model/solids model/solids/shells model/text |"
    "model/export/files            | model           | model/board model/export/drawings model/export/meshes model/export/solids model/geometry model/geometry/loops model/text |"
    "model/export/meshes           | model           | model/board model/export/solids model/geometry model/geometry/loops model/solids/shells model/text tri | json meshopt"
    "model/session                 | model::session  | model/board model/clearance model/measure model/solids model/text | json"
    "model/generate                | model::generate | model/text | archive"
    "model/formats/common          | model::formats  | model/board model/figures model/geometry model/geometry/loops model/solids/shells | archive deflate"
    "model/formats/steps           | model::formats  | model/board model/formats/common model/geometry model/geometry/loops model/solids/shells |"
    "model/formats/drawing         | model::formats  | model/board model/formats/common model/formats/steps model/geometry model/packages model/solids |"
    "model/formats/odb/text        | model::odb      | model/board model/formats/common model/geometry model/text |"
    "model/formats/odb/features    | model::odb      | model/board model/formats/common model/formats/odb/text model/geometry |"
    "model/formats/odb/components  | model::odb      | model/board model/formats/common model/formats/odb/features model/formats/odb/text |"
    "model/formats/odb/stackup     | model::odb      | model/board model/formats/odb/features model/formats/odb/text model/geometry | xml"
    "model/formats/odb/steps       | model::odb      | model/board model/formats/odb/components model/formats/odb/features model/formats/odb/stackup model/formats/odb/text |"
    "model/formats/odb/symbols     | model::odb      | model/formats/common model/formats/odb/features model/formats/odb/text model/geometry |"
    "model/formats/odb/elements    | model::odb      | model/board model/formats/common model/formats/odb/steps model/formats/odb/symbols model/formats/odb/text model/geometry |"
    "model/formats/odb             | model::odb      | model/board model/formats/common model/formats/odb/elements model/formats/odb/features model/formats/odb/stackup model/formats/odb/steps model/formats/odb/text model/formats/steps model/geometry model/packages model/solids |"
    "model/formats/ipc2581/xml     | model::ipc2581  | model/text |"
    "model/formats/ipc2581/shapes  | model::ipc2581  | model/formats/common model/formats/ipc2581/xml model/geometry |"
    "model/formats/ipc2581         | model::ipc2581  | model/board model/formats/common model/formats/drawing model/formats/ipc2581/shapes model/formats/ipc2581/xml model/geometry model/geometry/loops |"
    "model/formats/gerber/text     | model::gerber   | |"
    "model/formats/gerber/image    | model::gerber   | model/board model/formats/common model/formats/drawing model/formats/gerber/text model/geometry model/geometry/loops model/text |"
    "model/formats/gerber/drills   | model::gerber   | model/formats/drawing model/formats/gerber/image model/formats/gerber/text model/geometry |"
    "model/formats/gerber/naming   | model::gerber   | model/board model/formats/gerber/image model/formats/gerber/text |"
    "model/formats/gerber/netlist  | model::gerber   | model/board model/formats/gerber/text |"
    "model/formats/gerber          | model::gerber   | model/board model/formats/common model/formats/drawing model/formats/gerber/drills model/formats/gerber/image model/formats/gerber/naming model/formats/gerber/netlist model/formats/gerber/text model/geometry model/nets model/text | json"
    "model/formats/kicad/text      | model::kicad    | model/board model/formats/common | barcode"
    "model/formats/kicad/shapes    | model::kicad    | model/formats/common model/geometry model/geometry/loops |"
    "model/formats/kicad           | model::kicad    | model/board model/formats/common model/formats/drawing model/formats/kicad/shapes model/formats/kicad/text model/geometry model/geometry/loops model/text | json"
    "model/formats/paper           | model::paper    | model/board model/geometry |"
    "model/formats                 | model           | model/board model/formats/common model/formats/drawing model/formats/gerber model/formats/ipc2581 model/formats/kicad model/formats/kicad/text model/formats/odb model/formats/odb/text model/formats/paper model/nets model/text |"
    "model/opening                 | model           | model/board model/clearance model/formats model/session |"
    "shaders/shared                | shader          | | glm"
    "shaders/tri                   | shader::tri     | | glm"
    "shaders/lib                   |                 | shaders/shared |"
    "shaders                       | shader::spirv   | shaders/lib shaders/shared shaders/tri |"
    "tri                           | tri             | | cgal"
    "tri/gpu                       | tri::gpu        | tri render/gpu shaders shaders/tri | vulkan"
    "render/gpu                    | render::gpu     | model/text | vulkan log"
    "render/modelling              | render          | model/board model/figures model/geometry model/packages model/solids shaders/shared tri | glm"
    "render/standard               | render          | model/board model/figures model/geometry render/modelling shaders/shared | glm"
    "render/scene                  | render          | model/board model/index model/section render/gpu render/modelling render/standard shaders/shared | glm log vulkan"
    "render/culling                | render          | render/modelling render/scene shaders/shared | glm"
    "render/tiles                  | render          | render/culling render/modelling render/scene shaders/shared | glm"
    "render/backends               | render          | model/text render/culling render/gpu render/modelling render/scene shaders shaders/shared | vulkan"
    "render/frame                  | render          | render/backends render/culling render/gpu render/modelling render/scene render/standard | glm log png vulkan"
    "render/calibration            | render          | model/board model/formats/common model/formats/odb model/generate render/backends render/culling render/frame render/gpu render/modelling render/scene | log"
    "ui/canvas                     | ui              | render/frame render/gpu render/scene render/tiles | qt widgets vulkan"
    "ui/common                     | ui              | model/board model/export model/text | qt widgets"
    "ui/workspace                  | ui              | model/board model/formats model/formats/common model/geometry model/index model/nets model/opening model/session model/statistics model/text render/modelling render/scene ui/canvas ui/common | qt widgets"
    "ui/theme                      | ui              | ui/workspace | qt widgets"
    "ui/layers                     | ui              | model/board model/session render/scene ui/common ui/workspace | qt widgets"
    "ui/assignment                 | ui              | model/formats/common model/formats/gerber ui/common ui/workspace | qt widgets"
    "ui/nets                       | ui              | model/board model/nets model/session model/text render/scene ui/common ui/workspace | qt widgets"
    "ui/findings                   | ui              | model/board ui/common ui/views ui/workspace | qt widgets"
    "ui/netlist_check              | ui              | model/board model/nets ui/common ui/findings ui/workspace | qt widgets"
    "ui/comparison                 | ui              | model/agreement model/board model/geometry model/opening ui/common ui/findings ui/views ui/workspace | qt widgets glm"
    "ui/element                    | ui              | model/board model/index model/measure model/statistics render/frame render/modelling render/scene ui/canvas ui/common ui/layers ui/parts ui/workspace | qt widgets"
    "ui/stackup                    | ui              | model/board model/export model/session model/solids ui/common ui/layers ui/workspace | qt widgets"
    "ui/statistics                 | ui              | model/board model/statistics ui/common ui/workspace | qt widgets"
    "ui/search                     | ui              | model/board model/index model/nets model/text ui/common ui/layers ui/nets ui/parts ui/views ui/workspace | qt widgets glm"
    "ui/messages                   | ui              | model/board render/modelling render/scene ui/common ui/views ui/workspace | qt widgets"
    "ui/parts                      | ui              | model/board model/index model/nets ui/common ui/workspace | qt widgets"
    "ui/views                      | ui              | model/board model/figures model/geometry model/index model/solids model/text render/frame render/modelling render/scene ui/canvas ui/common ui/element ui/layers ui/nets ui/parts ui/workspace | qt widgets glm"
    "ui/saved_views                | ui              | model/board model/session ui/common ui/layers ui/views ui/workspace | qt widgets glm"
    "ui/measure                    | ui              | model/board model/index model/measure model/session ui/common ui/views ui/workspace | qt widgets"
    "ui/clearance                  | ui              | model/board model/clearance model/design_rules model/export model/index model/measure model/session model/text render/scene ui/common ui/findings ui/layers ui/views ui/workspace | qt widgets"
    "ui/section                    | ui              | model/board model/export model/index model/measure model/section model/session render/scene ui/canvas ui/common ui/layers ui/views ui/workspace | qt widgets glm"
    "ui/export                     | ui              | model/board model/export/files model/export/solids model/text render/scene ui/common ui/layers ui/views ui/workspace | qt widgets"
    "ui/shell                      | ui              | model/board model/formats model/opening render/calibration render/gpu render/scene ui/assignment ui/canvas ui/clearance ui/common ui/comparison ui/element ui/export ui/layers ui/measure ui/messages ui/netlist_check ui/nets ui/parts ui/saved_views ui/search ui/section ui/stackup ui/statistics ui/theme ui/views ui/workspace | qt widgets"
    "app/common                    | app             | model/board model/formats model/opening model/session model/solids model/text render/gpu render/modelling render/scene tri tri/gpu | json log"
    "app/reports                   | app             | app/common model/board model/clearance model/index model/nets model/statistics render/modelling render/standard | json"
    "app/verify                    | app             | app/common model/board model/export/solids model/figures model/geometry model/geometry/loops model/solids/shells model/text render/frame render/gpu render/modelling render/scene render/standard | dl json"
    "app/step_reader               | app             | app/verify | occt"
    "app/bench                     | app tri::bench  | app/common model/board model/formats model/text render/backends render/calibration render/frame render/gpu render/modelling render/scene render/standard tri tri/gpu | json"
    "app/clearance                 | app             | app/common model/board model/clearance model/design_rules model/export model/text render/frame render/scene | "
    "app/commands                  | app             | app/bench app/clearance app/common app/reports app/verify model/agreement model/board model/clearance model/export model/export/files model/export/solids model/formats model/formats/common model/formats/gerber model/generate model/index model/measure model/solids model/text render/frame render/gpu render/scene render/standard render/tiles ui/shell | cli json"
    "app/manual                    | app             | | cli"
    "app                           |                 | app/commands app/common app/manual | log"
)

# A library by the name it has above: how an include of it is told, and what is linked.
set(architecture_include_qt "^(Qt[A-Z][A-Za-z]*(/.*)?|Q[A-Z][A-Za-z0-9]*|q[a-z0-9]+\\.h)$")
set(architecture_include_widgets
    "^QtWidgets|Q(Application|MainWindow|DesktopWidget|Label|Menu|MenuBar|ToolBar|StatusBar|Slider|Splitter|Frame|Completer|ProgressBar)$|^Q[A-Za-z]*(Widget|View|Layout|Button|Dialog|Box|Edit|Delegate|Style|Area|Bar)$")
set(architecture_include_vulkan "^vulkan/")
set(architecture_include_archive "^archive")
set(architecture_include_barcode "^zint\\.h$")
set(architecture_include_cgal "^CGAL/")
set(architecture_include_cli "^CLI/")
set(architecture_include_clipper "^polyclipping/")
set(architecture_include_dl "^dlfcn\\.h$")  # loading code: one module of ours (SECURITY.md)
set(architecture_include_deflate "^libdeflate\\.h$")
set(architecture_include_json "^nlohmann/")
set(architecture_include_log "^spdlog/")
set(architecture_include_meshopt "^meshoptimizer\\.h$")
set(architecture_include_occt "^(BRep|Bnd|GProp|Message|STEP|Shape|Standard|TopExp|TopoDS)[A-Za-z0-9]*(_[A-Za-z0-9]+)*\\.hxx$")
set(architecture_include_png "^png\\.h$")
set(architecture_include_tbb "^tbb/")
set(architecture_include_xml "^pugixml")
set(architecture_include_zlib "^zlib\\.h$")
set(architecture_link_qt Qt6::Core Qt6::Gui)
set(architecture_link_widgets Qt6::Widgets)
set(architecture_link_vulkan Vulkan::Vulkan)
set(architecture_link_archive LibArchive::LibArchive)
set(architecture_link_barcode copperscope_zint)
set(architecture_link_cgal CGAL::CGAL)
set(architecture_link_cli CLI11::CLI11)
set(architecture_link_clipper PkgConfig::POLYCLIPPING)
set(architecture_link_dl ${CMAKE_DL_LIBS})
set(architecture_link_deflate PkgConfig::DEFLATE)
set(architecture_link_glm glm::glm)
set(architecture_link_json nlohmann_json::nlohmann_json)
set(architecture_link_log spdlog::spdlog)
set(architecture_link_meshopt meshoptimizer::meshoptimizer)
set(architecture_link_occt ${COPPERSCOPE_OCCT})
set(architecture_link_png PNG::PNG)
set(architecture_link_tbb TBB::tbb)
set(architecture_link_xml pugixml::pugixml)
set(architecture_link_zlib ZLIB::ZLIB)

# Takes architecture_rows apart into rule_folders and, for each folder, namespaces_of_, may_include_ and may_use_<folder>.
macro(read_architecture)
    foreach(row IN LISTS architecture_rows)
        string(REPLACE "|" ";" columns "${row}")
        list(GET columns 0 folder)
        string(STRIP "${folder}" folder)
        list(APPEND rule_folders ${folder})
        foreach(column name IN ZIP_LISTS columns architecture_columns)
            separate_arguments(${name}_${folder} UNIX_COMMAND "${column}")
        endforeach()
        if(NOT folder MATCHES "^(model/base|shaders)")
            list(APPEND may_include_${folder} model/base)
        endif()
    endforeach()
endmacro()
set(architecture_columns folder namespaces_of may_include may_use)
