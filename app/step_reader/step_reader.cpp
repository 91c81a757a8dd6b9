// The loadable module behind app/verify/step_file.h.
#include "app/step_reader/step_reader.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gp.hxx>
#include <optional>
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

/// By the reader's integration, which is exact where edges are long enough: up to 1.4e-6 off where a small face has
/// hundreds of short edges, 1e-5 where a wall has bends.
double measuredVolume(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

bool isVertical(const gp_Dir& direction) {
    return direction.IsParallel(gp::DZ(), 1e-12) == Standard_True;
}

enum class FaceKind : std::uint8_t { Lid, Wall, Other };

/// A lid is a level plane; a wall runs up and down wherever it stands.
FaceKind kindOf(const BRepAdaptor_Surface& surface) {
    switch (surface.GetType()) {
        case GeomAbs_Plane: {
            const gp_Dir normal = surface.Plane().Axis().Direction();
            const bool isUpright = normal.IsNormal(gp::DZ(), 1e-9) == Standard_True;
            return isVertical(normal) ? FaceKind::Lid : isUpright ? FaceKind::Wall : FaceKind::Other;
        }
        case GeomAbs_Cylinder:
            return isVertical(surface.Cylinder().Axis().Direction()) ? FaceKind::Wall : FaceKind::Other;
        case GeomAbs_SurfaceOfExtrusion: return isVertical(surface.Direction()) ? FaceKind::Wall : FaceKind::Other;
        default: return FaceKind::Other;
    }
}

/// Twice the area between the edge and the corner `from`, as the curve runs; none for curves but lines, circles and
/// polylines, which are B-splines of degree 1 to the reader.
std::optional<double> twiceAreaUnder(const BRepAdaptor_Curve& curve, const gp_Pnt& from) {
    const auto wedge = [&](const gp_Pnt& a, const gp_Pnt& b) {
        return (a.X() - from.X()) * (b.Y() - from.Y()) - (a.Y() - from.Y()) * (b.X() - from.X());
    };
    const double first = curve.FirstParameter();
    const double last = curve.LastParameter();
    if (curve.GetType() == GeomAbs_Line) {
        return wedge(curve.Value(first), curve.Value(last));
    }
    if (curve.GetType() == GeomAbs_Circle) {
        const double sign = curve.Circle().Axis().Direction().Z() < 0 ? -1.0 : 1.0;
        const double radius = curve.Circle().Radius();
        const double segment = radius * radius * (last - first - std::sin(last - first));
        return wedge(curve.Value(first), curve.Value(last)) + sign * segment;
    }
    if (curve.GetType() != GeomAbs_BSplineCurve || curve.Degree() != 1) {
        return std::nullopt;
    }
    const Handle(Geom_BSplineCurve) bends = curve.BSpline();
    double sum = 0.0;
    for (int i = bends->FirstUKnotIndex(); i < bends->LastUKnotIndex(); ++i) {
        const double start = std::max(bends->Knot(i), first);
        const double end = std::min(bends->Knot(i + 1), last);
        sum += start < end ? wedge(curve.Value(start), curve.Value(end)) : 0.0;
    }
    return sum;
}

/// Of a lid, positive when it faces upwards; none with curves whose area has no formula here.
std::optional<double> areaOfLid(const TopoDS_Face& lid, const gp_Pnt& from) {
    double twice = 0.0;
    for (TopExp_Explorer wire(lid, TopAbs_WIRE); wire.More(); wire.Next()) {
        for (TopExp_Explorer at(wire.Current(), TopAbs_EDGE); at.More(); at.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(at.Current());
            const std::optional<double> area = twiceAreaUnder(BRepAdaptor_Curve(edge), from);
            if (!area) {
                return std::nullopt;
            }
            twice += edge.Orientation() == TopAbs_REVERSED ? -*area : *area;
        }
    }
    return twice / 2;
}

/// From the lids alone: walls that run up and down have no share in the integral of the height over the surface. None
/// for solids with other faces.
std::optional<double> volumeOfPrism(const TopoDS_Shape& shape) {
    const gp_Pnt from = BRep_Tool::Pnt(TopoDS::Vertex(TopExp_Explorer(shape, TopAbs_VERTEX).Current()));
    double volume = 0.0;
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
        const TopoDS_Face& face = TopoDS::Face(at.Current());
        const BRepAdaptor_Surface surface(face);
        const FaceKind kind = kindOf(surface);
        const std::optional<double> area = kind == FaceKind::Lid ? areaOfLid(face, from) : std::optional(0.0);
        if (kind == FaceKind::Other || !area) {
            return std::nullopt;
        }
        volume += kind == FaceKind::Lid ? *area * (surface.Plane().Location().Z() - from.Z()) : 0.0;
    }
    return std::abs(volume);
}

Quality qualityOf(const TopoDS_Shape& shape) {
    ShapeAnalysis_ShapeTolerance tolerance;
    int shells = 0;
    bool isClosed = true;
    for (TopExp_Explorer at(shape, TopAbs_SHELL); at.More(); at.Next()) {
        ++shells;
        isClosed = isClosed && BRep_Tool::IsClosed(at.Current());
    }
    const std::optional<double> exact = volumeOfPrism(shape);
    const double volume = exact ? *exact : measuredVolume(shape);
    return {volume * kNmPerUnit * kNmPerUnit * kNmPerUnit, tolerance.Tolerance(shape, 1) * kNmPerUnit,
            BRepCheck_Analyzer(shape).IsValid() == Standard_True, isClosed && shells == 1};
}

/// Settings of a reader that makes few repairs, in a file as it looks for it. Errors: OutputFailed.
base::Status writeStrictSettings(const fs::path& path) {
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
    std::ofstream file(path);
    file << "FromSTEP.exec.op: FixShape\n";
    for (const char* mode : kKept) {
        file << "FromSTEP.FixShape.Fix" << mode << "Mode: 1\n";
    }
    for (const char* mode : kLeft) {
        file << "FromSTEP.FixShape.Fix" << mode << "Mode: 0\n";
    }
    file.close();
    return file ? base::Status(base::Done{})
                : base::Error{base::ErrorCode::OutputFailed, path.string() + " cannot be written"};
}

/// While it lives, the reader takes its repairs from the file named STEP in the folder.
class StrictReading {
public:
    explicit StrictReading(const fs::path& folder) { ::setenv("CSF_STEPDefaults", folder.c_str(), 1); }
    ~StrictReading() { ::unsetenv("CSF_STEPDefaults"); }
    StrictReading(const StrictReading&) = delete;
    StrictReading& operator=(const StrictReading&) = delete;
};

/// Asked by the reader whether it is to stop.
class StopSign : public Message_ProgressIndicator {
public:
    explicit StopSign(const base::Progress& progress) : m_progress(progress) {}
    Standard_Boolean UserBreak() override { return m_progress.isCancelled(); }
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

private:
    const base::Progress& m_progress;
};

base::Error cannotRead(const fs::path& path, const std::string& why) {
    return {base::ErrorCode::BadInput, path.string() + " cannot be read as STEP: " + why};
}

/// The solids of a file, as OpenCASCADE holds them.
class OcctStepFile : public StepFile {
public:
    explicit OcctStepFile(std::vector<TopoDS_Solid> solids) : m_solids(std::move(solids)) {}

    [[nodiscard]] std::size_t size() const override { return m_solids.size(); }
    [[nodiscard]] StepSolid solid(std::size_t row) const override;
    [[nodiscard]] bool contains(std::size_t row, const std::array<double, 3>& point) const override;

private:
    std::vector<TopoDS_Solid> m_solids;
    mutable std::unordered_map<const void*, Quality> m_qualities;  ///< by what equal solids share
};

StepSolid OcctStepFile::solid(std::size_t row) const {
    const TopoDS_Solid& shape = m_solids[row];
    const void* shared = shape.TShape().get();
    auto known = m_qualities.find(shared);
    if (known == m_qualities.end()) {
        known = m_qualities.emplace(shared, qualityOf(shape)).first;
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

bool OcctStepFile::contains(std::size_t row, const std::array<double, 3>& point) const {
    const gp_Pnt at(point[0] / kNmPerUnit, point[1] / kNmPerUnit, point[2] / kNmPerUnit);
    const BRepClass3d_SolidClassifier classifier(m_solids[row], at, 1e-7);
    return classifier.State() == TopAbs_IN || classifier.State() == TopAbs_ON;
}

base::Result<std::unique_ptr<StepFile>> read(const fs::path& path, const fs::path& strictIn,
                                             const base::Progress& progress) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    std::optional<StrictReading> strict;
    if (!strictIn.empty()) {
        RETURN_IF_ERROR(writeStrictSettings(strictIn / "STEP"));
        strict.emplace(strictIn);
    }
    std::vector<TopoDS_Solid> solids;
    try {
        STEPControl_Reader reader;
        if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
            return cannotRead(path, "it is damaged, or no STEP file");
        }
        const Handle(StopSign) stop = new StopSign(progress);
        reader.TransferRoots(stop->Start());
        if (progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "reading STEP was cancelled"};
        }
        for (TopExp_Explorer at(reader.OneShape(), TopAbs_SOLID); at.More(); at.Next()) {
            solids.push_back(TopoDS::Solid(at.Current()));
        }
    } catch (const Standard_Failure& failure) {
        return cannotRead(path, failure.GetMessageString());
    }
    return std::unique_ptr<StepFile>(std::make_unique<OcctStepFile>(std::move(solids)));
}

}  // namespace

void readStepFile(const fs::path& path, const fs::path& strictIn, const base::Progress& progress,
                  base::Result<std::unique_ptr<StepFile>>& result) {
    result = read(path, strictIn, progress);
}

}  // namespace app
