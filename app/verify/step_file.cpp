#include "app/verify/step_file.h"

#include <unistd.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <cstdlib>
#include <fstream>
#include <unordered_map>
#include <vector>

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr double kNmPerUnit = 1e6;  ///< the reader's unit is the millimetre

/// What a solid has wherever it is placed.
struct Quality {
    double volume;
    double tolerance;
    bool isValid;
    bool isClosed;
};

/// By the reader's integration, which is exact where edges are long enough.
double measuredVolume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

bool isPolyhedron(const TopoDS_Shape& shape) {
    for (TopExp_Explorer at(shape, TopAbs_EDGE); at.More(); at.Next()) {
        if (BRepAdaptor_Curve(TopoDS::Edge(at.Current())).GetType() != GeomAbs_Line) {
            return false;
        }
    }
    return true;
}

/// From the corners of its faces. The reader's integration is up to 1.4e-6 off where a small face has hundreds of
/// short edges.
double volumeOfPolyhedron(const TopoDS_Shape& shape) {
    double sixfold = 0.0;
    const gp_XYZ apex = BRep_Tool::Pnt(TopoDS::Vertex(TopExp_Explorer(shape, TopAbs_VERTEX).Current())).XYZ();
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        for (TopExp_Explorer wire(face.Current(), TopAbs_WIRE); wire.More(); wire.Next()) {
            std::vector<gp_XYZ> corners;
            const TopoDS_Face& within = TopoDS::Face(face.Current());
            for (BRepTools_WireExplorer at(TopoDS::Wire(wire.Current()), within); at.More(); at.Next()) {
                corners.push_back(BRep_Tool::Pnt(at.CurrentVertex()).XYZ() - apex);
            }
            for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
                sixfold += corners[0].DotCross(corners[i], corners[i + 1]);
            }
        }
    }
    return std::abs(sixfold) / 6;
}

Quality qualityOf(const TopoDS_Shape& shape) {
    ShapeAnalysis_ShapeTolerance tolerance;
    int shells = 0;
    bool isClosed = true;
    for (TopExp_Explorer at(shape, TopAbs_SHELL); at.More(); at.Next()) {
        ++shells;
        isClosed = isClosed && BRep_Tool::IsClosed(at.Current());
    }
    const double volume = isPolyhedron(shape) ? volumeOfPolyhedron(shape) : measuredVolume(shape);
    return {volume * kNmPerUnit * kNmPerUnit * kNmPerUnit, tolerance.Tolerance(shape, 1) * kNmPerUnit,
            BRepCheck_Analyzer(shape).IsValid() == Standard_True, isClosed && shells == 1};
}

/// The reader takes its repairs from a file named STEP in the folder that the environment names.
class StrictReading {
public:
    StrictReading() : m_folder(fs::temp_directory_path() / ("copperscope-strict-" + std::to_string(::getpid()))) {
        static constexpr const char* kKept[] = {"Solid",     "Shell",      "Face",          "Wire",        "EdgeCurves",
                                                "AddPCurve", "AddCurve3d", "SameParameter", "MissingSeam", "Shifted"};
        static constexpr const char* kLeft[] = {"FreeShell",
                                                "FreeFace",
                                                "FreeWire",
                                                "Orientation",
                                                "SmallAreaWire",
                                                "IntersectingWires",
                                                "LoopWires",
                                                "SplitFace",
                                                "Reorder",
                                                "Small",
                                                "Connected",
                                                "Degenerated",
                                                "Lacking",
                                                "SelfIntersection",
                                                "Gaps3d",
                                                "Gaps2d",
                                                "Reversed2d",
                                                "RemovePCurve",
                                                "RemoveCurve3d",
                                                "Seam",
                                                "SelfIntersectingEdge",
                                                "IntersectingEdges",
                                                "NonAdjacentIntersectingEdges",
                                                "Tail"};
        fs::create_directories(m_folder);
        std::ofstream file(m_folder / "STEP");
        file << "FromSTEP.exec.op: FixShape\n";
        for (const char* mode : kKept) {
            file << "FromSTEP.FixShape.Fix" << mode << "Mode: 1\n";
        }
        for (const char* mode : kLeft) {
            file << "FromSTEP.FixShape.Fix" << mode << "Mode: 0\n";
        }
        ::setenv("CSF_STEPDefaults", m_folder.c_str(), 1);
    }
    ~StrictReading() {
        ::unsetenv("CSF_STEPDefaults");
        std::error_code error;
        fs::remove_all(m_folder, error);
    }
    StrictReading(const StrictReading&) = delete;
    StrictReading& operator=(const StrictReading&) = delete;

private:
    fs::path m_folder;
};

base::Error cannotRead(const fs::path& path, const std::string& why) {
    return {base::ErrorCode::BadInput, path.string() + " cannot be read as STEP: " + why};
}

}  // namespace

struct StepFile::Shapes {
    std::vector<TopoDS_Solid> solids;
    mutable std::unordered_map<const void*, Quality> qualities;  ///< by what equal solids share
};

StepFile::StepFile(std::unique_ptr<Shapes> shapes) : m_shapes(std::move(shapes)) {}
StepFile::StepFile(StepFile&&) noexcept = default;
StepFile::~StepFile() = default;

base::Result<StepFile> StepFile::read(const fs::path& path, bool isStrict) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    const std::unique_ptr<StrictReading> strict = isStrict ? std::make_unique<StrictReading>() : nullptr;
    auto shapes = std::make_unique<Shapes>();
    try {
        STEPControl_Reader reader;
        if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
            return cannotRead(path, "it is damaged, or no STEP file");
        }
        reader.TransferRoots();
        for (TopExp_Explorer at(reader.OneShape(), TopAbs_SOLID); at.More(); at.Next()) {
            shapes->solids.push_back(TopoDS::Solid(at.Current()));
        }
    } catch (const Standard_Failure& failure) {
        return cannotRead(path, failure.GetMessageString());
    }
    return StepFile(std::move(shapes));
}

std::size_t StepFile::size() const {
    return m_shapes->solids.size();
}

StepSolid StepFile::solid(std::size_t row) const {
    const TopoDS_Solid& shape = m_shapes->solids[row];
    const void* shared = shape.TShape().get();
    auto known = m_shapes->qualities.find(shared);
    if (known == m_shapes->qualities.end()) {
        known = m_shapes->qualities.emplace(shared, qualityOf(shape)).first;
    }
    const Quality& quality = known->second;
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, Standard_False, Standard_False);
    StepSolid solid{quality.volume, quality.tolerance, quality.isValid, quality.isClosed, {}};
    box.Get(solid.box[0], solid.box[1], solid.box[2], solid.box[3], solid.box[4], solid.box[5]);
    for (double& value : solid.box) {
        value *= kNmPerUnit;
    }
    return solid;
}

bool StepFile::contains(std::size_t row, const std::array<double, 3>& point) const {
    const gp_Pnt at(point[0] / kNmPerUnit, point[1] / kNmPerUnit, point[2] / kNmPerUnit);
    const BRepClass3d_SolidClassifier classifier(m_shapes->solids[row], at, 1e-7);
    return classifier.State() == TopAbs_IN || classifier.State() == TopAbs_ON;
}

}  // namespace app
