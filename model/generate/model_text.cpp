#include "model/generate/model_text.h"

#include <cmath>
#include <numbers>
#include <span>

namespace model::generate {

namespace {

/// A control point in micrometres.
struct Control {
    double x = 0.0;
    double y = 0.0;
    double weight = 1.0;
};

/// Knots of a curve of this degree that is clamped, with its inner knots at equal steps.
std::vector<double> evenKnots(std::size_t degree, std::size_t controls) {
    std::vector<double> knots(degree + 1, 0.0);
    for (std::size_t i = degree + 1; i < controls; ++i) {
        knots.push_back(static_cast<double>(i - degree));
    }
    knots.insert(knots.end(), degree + 1, static_cast<double>(controls - degree));
    return knots;
}

/// Writes records of the format; lengths come in micrometres.
class ModelWriter {
public:
    explicit ModelWriter(TextSink& out) : m_out(out) {}

    void beginLayer(std::string_view type, double base, double thickness) {
        m_out << "LAYERBEGIN\nLAYERTYPE," << type << "\nBASEPLANEHEIGHT";
        length(base);
        m_out << "\nTHICKNESS";
        length(thickness);
        m_out << "\n";
    }
    void endLayer() { m_out << "LAYEREND\n"; }

    void beginRecord(bool isShape) {
        m_out << (isShape ? "SHAPEBEGIN\nSHAPEID," : "LINEBEGIN\nLINEID,") << ++m_id << "\n";
    }
    void endRecord(bool isShape) { m_out << (isShape ? "SHAPEEND\n" : "LINEEND\n"); }

    void beginContour(std::string_view word, std::size_t points, Control start) {
        m_out << word << "," << static_cast<std::int64_t>(points) << "\n";
        number(mil(start.x), false);
        length(start.y);
        m_out << "\n";
    }
    void straight(double width, Control to) {
        m_out << "STRAIGHT,1";
        length(width);
        point(to);
        m_out << "\n";
    }
    void clockwiseArc(double width, Control centre, Control to) {
        m_out << "ARC,1";
        length(width);
        point(centre);
        point(to);
        m_out << ",CW\n";
    }
    /// From where the chain is: controls[0].
    void curve(std::size_t degree, std::span<const Control> controls, std::span<const double> knots) {
        m_out << "NURBS,1,0," << static_cast<std::int64_t>(degree) << "," << static_cast<std::int64_t>(controls.size());
        number(controls[0].weight);
        for (const Control& control : controls.subspan(1)) {
            point(control);
            number(control.weight);
        }
        for (const double knot : knots) {
            number(knot);
        }
        m_out << "\n";
    }
    void circle(std::string_view word, Control centre, double radius) {
        m_out << word << ",1\nCIRCLE,1,0";
        point(centre);
        length(radius);
        m_out << "\n";
    }

private:
    static double mil(double um) { return um / 25.4; }

    void number(double value, bool isAfterComma = true) {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
        m_out << (isAfterComma ? "," : "") << std::string_view(digits, static_cast<std::size_t>(end - digits));
    }
    void length(double um) { number(mil(um)); }
    void point(Control at) {
        length(at.x);
        length(at.y);
    }

    TextSink& m_out;
    std::int64_t m_id = 0;
};

Control controlAt(PointUm p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

// ---- pads ----

/// By Pen, µm: the width of tracks and the diameter of discs, or width, height and radius of the corners.
struct PenSize {
    double width;
    double height = 0.0;
    double corner = 0.0;
};
constexpr PenSize kSizes[] = {{75}, {100}, {300}, {350}, {150}, {200, 480, 60}, {220, 500, 60}, {240, 520, 80}};

PenSize sizeOf(Pen pen) {
    return kSizes[static_cast<std::size_t>(pen)];
}

/// A box whose corners are curves between the two sides, counter-clockwise. `pull` is how far inner control points lie
/// on the way to the corner; of degree 2 there is one, in the corner, with the weight that makes a circle.
void writeCornerPad(ModelWriter& out, Control centre, const PenSize& size, std::size_t degree) {
    constexpr double kPull = 0.75;
    constexpr int kX[] = {1, -1, -1, 1};
    constexpr int kY[] = {1, 1, -1, -1};
    const double x = size.width / 2;
    const double y = size.height / 2;
    const auto onSide = [&](int corner, double back) {
        return Control{centre.x + kX[corner] * x, centre.y + kY[corner] * (y - back)};
    };
    const auto onFlat = [&](int corner, double back) {
        return Control{centre.x + kX[corner] * (x - back), centre.y + kY[corner] * y};
    };
    out.beginContour("SHAPEDATA", 9, onSide(0, size.corner));
    for (int corner = 0; corner < 4; ++corner) {
        const bool isSideFirst = corner % 2 == 0;
        const auto before = [&](double back) { return isSideFirst ? onSide(corner, back) : onFlat(corner, back); };
        const auto after = [&](double back) { return isSideFirst ? onFlat(corner, back) : onSide(corner, back); };
        std::vector<Control> controls{before(size.corner)};
        if (degree == 2) {
            controls.push_back(before(0.0));
            controls.back().weight = std::numbers::sqrt2 / 2;
        } else {
            controls.push_back(before(size.corner * (1 - kPull)));
            controls.push_back(after(size.corner * (1 - kPull)));
        }
        controls.push_back(after(size.corner));
        out.curve(degree, controls, evenKnots(degree, controls.size()));
        const int next = (corner + 1) % 4;
        out.straight(0, isSideFirst ? onFlat(next, size.corner) : onSide(next, size.corner));
    }
}

/// One closed curve whose control points lie on the outline of the box, evenly by angle.
void writeRoundPad(ModelWriter& out, Control centre, const PenSize& size) {
    constexpr std::size_t kControls = 16;
    std::vector<Control> controls;
    for (std::size_t i = 0; i < kControls; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / (kControls - 1);
        const double reach = std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
        controls.push_back({centre.x + size.width / 2 * std::cos(angle) / reach,
                            centre.y + size.height / 2 * std::sin(angle) / reach, i % 3 == 1 ? 2.0 : 1.0});
    }
    controls.back() = controls.front();
    out.beginContour("SHAPEDATA", 2, controls.front());
    out.curve(3, controls, evenKnots(3, kControls));
}

void writePad(ModelWriter& out, const Feature& pad) {
    const Control at = controlAt(pad.a);
    const PenSize size = sizeOf(pad.pen);
    out.beginRecord(true);
    switch (pad.pen) {
        case Pen::PadSmall: writeCornerPad(out, at, size, 2); break;
        case Pen::PadMiddle: writeCornerPad(out, at, size, 3); break;
        case Pen::PadLarge: writeRoundPad(out, at, size); break;
        default:
            // Two circles are a disc or a hole: the inner one of drills leaves 20 µm of plating.
            out.circle("SHAPEDATA", at, size.width / 2);
            out.circle("VOIDDATA", at, pad.pen == Pen::Drill ? size.width / 2 - 20 : 0.0);
    }
    out.endRecord(true);
}

// ---- tracks ----

/// Tracks from `first` on that start where the one before ends, as one record; returns the number of the next feature.
std::size_t writeTracks(ModelWriter& out, std::span<const Feature> features, std::size_t first) {
    std::size_t end = first + 1;
    while (end < features.size() && features[end].kind == Feature::Kind::Track &&
           features[end].pen == features[first].pen && features[end].a == features[end - 1].b) {
        ++end;
    }
    const double width = sizeOf(features[first].pen).width;
    out.beginRecord(false);
    out.beginContour("LINEDATA", end - first + 1, controlAt(features[first].a));
    for (std::size_t i = first; i < end; ++i) {
        out.straight(width, controlAt(features[i].b));
    }
    out.endRecord(false);
    return end;
}

void writeArc(ModelWriter& out, const Feature& arc) {
    out.beginRecord(false);
    out.beginContour("LINEDATA", 2, controlAt(arc.a));
    out.clockwiseArc(sizeOf(arc.pen).width, controlAt(arc.centre), controlAt(arc.b));
    out.endRecord(false);
}

void writeBlocks(ModelWriter& out, const Layout& layout, BoardLayer plane, const base::Progress& progress) {
    for (std::uint64_t i = 0; i < layout.blockCount() && !progress.isCancelled(); ++i) {
        const Block block = layout.block(i);
        const std::vector<Feature>& features = block.features[static_cast<std::size_t>(plane)];
        for (std::size_t row = 0; row < features.size();) {
            const Feature& feature = features[row];
            if (feature.kind == Feature::Kind::Track) {
                row = writeTracks(out, features, row);
                continue;
            }
            feature.kind == Feature::Kind::Arc ? writeArc(out, feature) : writePad(out, feature);
            ++row;
        }
    }
}

// ---- planes ----

/// A side of a plane from one corner to the next, which waves to its left.
void writeSide(ModelWriter& out, Control from, Control to) {
    constexpr std::size_t kControls = 24;
    constexpr double kDepth = 60;
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    std::vector<Control> controls;
    for (std::size_t i = 0; i < kControls; ++i) {
        const double t = static_cast<double>(i) / (kControls - 1);
        const bool isEnd = i == 0 || i + 1 == kControls;
        const double inwards = isEnd || i % 4 < 2 ? 0.0 : kDepth;
        controls.push_back({from.x + (to.x - from.x) * t - (to.y - from.y) / length * inwards,
                            from.y + (to.y - from.y) * t + (to.x - from.x) / length * inwards, i % 5 == 2 ? 1.5 : 1.0});
    }
    out.curve(5, controls, evenKnots(5, kControls));
}

/// A full circle of nine control points, from the right of its centre.
void writeHole(ModelWriter& out, Control centre) {
    constexpr int kX[] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
    constexpr int kY[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    constexpr double kKnots[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    std::vector<Control> controls;
    for (std::size_t i = 0; i < 9; ++i) {
        controls.push_back({centre.x + kX[i] * double{Layout::kViaClearanceUm},
                            centre.y + kY[i] * double{Layout::kViaClearanceUm},
                            i % 2 == 0 ? 1.0 : std::numbers::sqrt2 / 2});
    }
    out.beginContour("VOIDDATA", 2, controls.front());
    out.curve(2, controls, kKnots);
}

void writePlanes(ModelWriter& out, const Layout& layout, bool isGround, const base::Progress& progress) {
    for (std::uint64_t i = 0; i < layout.tileCount() && !progress.isCancelled(); ++i) {
        const Tile tile = layout.tile(i);
        const Control corners[] = {controlAt(tile.min), controlAt({tile.max.x, tile.min.y}), controlAt(tile.max),
                                   controlAt({tile.min.x, tile.max.y})};
        out.beginRecord(true);
        out.beginContour("SHAPEDATA", 5, corners[0]);
        for (std::size_t side = 0; side < 4; ++side) {
            writeSide(out, corners[side], corners[(side + 1) % 4]);
        }
        for (const std::uint64_t index : tile.blocks) {
            const Block block = layout.block(index);
            for (const PointUm via : isGround ? block.viasNotOnGround : block.viasNotOnPower) {
                writeHole(out, controlAt(via));
            }
        }
        out.endRecord(true);
    }
}

// ---- layers ----

struct LayerText {
    std::string_view type;
    double base;
    double thickness;
};
// From below, µm: 35 µm copper outside, 17.5 µm inside, 1.6 mm in all, as in the job. Bottom grows downwards.
constexpr LayerText kBottom = {"Bottom", 0, 35};
constexpr LayerText kPower = {"Power", 200, 17.5};
constexpr LayerText kGround = {"Ground", 1312.5, 17.5};
constexpr LayerText kTop = {"Top", 1530, 35};
constexpr LayerText kSilk = {"Silk", 1565, 20};
constexpr LayerText kBarrels = {"MultiLayer", -35, 1600};
constexpr LayerText kSubstrates[] = {{"Plane", 0, 200}, {"Plane", 217.5, 1095}, {"Plane", 1330, 200}};

}  // namespace

void writeModelText(TextSink& out, const Layout& layout, const base::Progress& progress) {
    ModelWriter writer(out);
    const auto addLayer = [&](const LayerText& layer, const auto& write) {
        writer.beginLayer(layer.type, layer.base, layer.thickness);
        write();
        writer.endLayer();
    };
    const auto blocks = [&](BoardLayer plane) { return [&, plane] { writeBlocks(writer, layout, plane, progress); }; };
    const auto planes = [&](bool isGround) {
        return [&, isGround] { writePlanes(writer, layout, isGround, progress); };
    };
    addLayer(kTop, blocks(BoardLayer::Top));
    addLayer(kSilk, blocks(BoardLayer::Silk));
    addLayer(kGround, planes(true));
    addLayer(kPower, planes(false));
    addLayer(kBottom, blocks(BoardLayer::Bottom));
    addLayer(kBarrels, blocks(BoardLayer::Drill));
    for (const LayerText& substrate : kSubstrates) {
        addLayer(substrate, [] {});
    }
}

}  // namespace model::generate
