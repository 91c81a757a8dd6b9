// Boards cut open: what is on the one side is gone, the rest is as it was, and the cut shows what lies in it.
#include <QtTest>
#include <map>
#include <set>

#include "model/board/document_builder.h"
#include "model/formats/registry.h"
#include "model/section/section_material.h"
#include "render/frame/frame_measures.h"
#include "tests/gpu/gpu_fixture.h"
#include "tests/locations.h"

using namespace render;
using namespace render::test;
using model::Document;
using model::PointD;

namespace {

constexpr std::uint32_t kWidth = 800;
constexpr std::uint32_t kHeight = 600;
constexpr float kAspect = 4.0F / 3.0F;
constexpr model::Nm kMm = 1'000'000;

/// A board on the device, with what cutting it takes.
struct Board {
    std::shared_ptr<const Document> document;
    BoardModel model;
    std::vector<LayerStyle> styles;
    BoardScene scene;

    explicit Board(const std::shared_ptr<const Document>& from)
        : document(from), model(modelOf(*from)), styles(defaultStyles(*from)), scene(Gpu::get().device, model) {
        scene.setStyles(styles);
    }
    static BoardModel modelOf(const Document& document) {
        base::Progress progress;
        return *buildBoardModel(document, {}, progress);
    }
    /// Millimetres from the middle of the board.
    [[nodiscard]] std::shared_ptr<const SectionCut> cut(glm::dvec2 a, glm::dvec2 b) const {
        base::Progress progress;
        const auto nm = [&](glm::dvec2 p) { return PointD{p.x * 1e6 + model.origin.x, p.y * 1e6 + model.origin.y}; };
        return std::make_shared<SectionCut>(
            *makeSectionCut(**model::indexBoard(document, progress), model.origin, nm(a), nm(b)));
    }
    Image draw(const Camera& camera, const ViewSettings& settings) {
        return *Gpu::get().presenter.render(scene, camera, settings, kWidth, kHeight);
    }
    [[nodiscard]] Camera seen(NamedView view, bool isParallel) const {
        Camera camera;
        camera.setOrthographic(isParallel);
        camera.fit(model.boxMin, model.boxMax, view, kAspect);
        return camera;
    }
};

std::shared_ptr<const Document> sample() {
    base::Progress progress;
    return *model::readBoard(locations::kSample, {}, progress);
}

/// A plate of 30 mm with a pad, placed upright, turned and turned over.
std::shared_ptr<const Document> panel() {
    const auto addLayers = [](model::DocumentBuilder& builder) {
        for (int i = 0; i < 2; ++i) {
            model::Layer layer;
            layer.name = i == 0 ? "top" : "bottom";
            layer.type = model::LayerType::Signal;
            layer.side = i == 0 ? model::LayerSide::Top : model::LayerSide::Bottom;
            layer.z = i == 0 ? kMm : 0;
            layer.thickness = 100'000;
            layer.opposite = model::LayerId{std::size_t(1 - i)};
            builder.addLayer(layer);
        }
        builder.setBoardThickness(1'100'000);
    };
    model::DocumentBuilder step;
    addLayers(step);
    step.beginLayer(model::LayerId{0});
    model::ShapeSketch plate;
    plate.addPolygon(std::array<model::Point, 4>{{{0, 0}, {30 * kMm, 0}, {30 * kMm, 20 * kMm}, {0, 20 * kMm}}}, false);
    step.addArea({step.addShape(plate), {}}, {});
    step.beginLayer(model::LayerId{1});
    step.addLine({{5 * kMm, 5 * kMm}, {25 * kMm, 15 * kMm}, 3 * kMm, 0}, {});
    model::DocumentBuilder board;
    addLayers(board);
    const std::uint32_t row = board.addStep(step.finish());
    board.addInstance({row, {{-20 * kMm, -25 * kMm}, 0.0, false}, false});
    board.addInstance({row, {{-10 * kMm, 30 * kMm}, 90.0, false}, false});
    board.addInstance({row, {{45 * kMm, 5 * kMm}, 20.0, true}, true});
    model::ShapeSketch outline;
    outline.addPolygon(
        std::array<model::Point, 4>{
            {{-50 * kMm, -40 * kMm}, {50 * kMm, -40 * kMm}, {50 * kMm, 40 * kMm}, {-50 * kMm, 40 * kMm}}},
        false);
    board.setProfile(board.addShape(outline));
    return board.finish();
}

/// A plate of copper, flipped, with a print of 1 mm that has no counterpart.
std::shared_ptr<const Document> flippedPrint() {
    const auto addLayers = [](model::DocumentBuilder& builder) {
        for (const auto& [type, z, thickness] : {std::tuple(model::LayerType::Signal, kMm, kMm / 10),
                                                 std::tuple(model::LayerType::Signal, model::Nm{0}, kMm / 10),
                                                 std::tuple(model::LayerType::SilkScreen, kMm + kMm / 10, kMm)}) {
            model::Layer layer;
            layer.type = type;
            layer.side = z > 0 ? model::LayerSide::Top : model::LayerSide::Bottom;
            layer.z = z;
            layer.thickness = thickness;
            builder.addLayer(layer);
        }
        builder.layer(model::LayerId{0}).opposite = model::LayerId{1};
        builder.layer(model::LayerId{1}).opposite = model::LayerId{0};
        builder.setBoardThickness(1'100'000);
    };
    const auto addRectangle = [](model::DocumentBuilder& builder, model::Nm x, model::Nm y) {
        model::ShapeSketch sketch;
        sketch.addPolygon(std::array<model::Point, 4>{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}}, false);
        return builder.addShape(sketch);
    };
    model::DocumentBuilder step;
    addLayers(step);
    for (const std::size_t layer : {std::size_t{0}, std::size_t{2}}) {
        step.beginLayer(model::LayerId{layer});
        step.addArea({addRectangle(step, 15 * kMm, 10 * kMm), {}}, {});
    }
    model::DocumentBuilder board;
    addLayers(board);
    board.addInstance({board.addStep(step.finish()), {{0, 0}, 0.0, true}, true});
    board.setProfile(addRectangle(board, 20 * kMm, 15 * kMm));
    return board.finish();
}

/// 0.4 mm square: a laser via of 0.1 mm, plated 15 µm, from the top through 80 µm of dielectric to an inner pad.
std::shared_ptr<const Document> laserVia() {
    model::DocumentBuilder builder;
    const auto add = [&](const char* name, model::LayerType type, model::Nm z, model::Nm thickness) {
        model::Layer layer;
        layer.name = name;
        layer.type = type;
        layer.z = z;
        layer.thickness = thickness;
        layer.isSynthetic = type == model::LayerType::Body;
        layer.side = type == model::LayerType::Drill ? model::LayerSide::Through : model::LayerSide::Inner;
        return builder.addLayer(layer);
    };
    const auto top = add("top", model::LayerType::Signal, 220'000, 20'000);
    const auto inner = add("inner", model::LayerType::Signal, 120'000, 20'000);
    add("bottom", model::LayerType::Signal, 0, 20'000);
    const auto laser = add("laser", model::LayerType::Drill, 120'000, 120'000);
    const auto upper = add("board 1", model::LayerType::Body, 120'000, 100'000);
    builder.layer(laser).spanTop = top;
    builder.layer(laser).spanBottom = inner;
    const auto plate = [] {
        model::ShapeSketch sketch;
        constexpr model::Nm kHalf = 200'000;
        sketch.addPolygon(
            std::array<model::Point, 4>{{{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}}}, false);
        return sketch;
    };
    model::DocumentBuilder::Origin hole;
    hole.flags = model::kHole | model::kPlated | model::kVia;
    for (const auto copper : {top, inner}) {
        builder.beginLayer(copper);
        builder.addCircle({{0, 0}, 300'000, 0}, {});
    }
    builder.beginLayer(laser);
    builder.addCircle({{0, 0}, 100'000, 70'000}, hole);
    builder.beginLayer(upper);
    model::ShapeSketch drilled = plate();
    drilled.addCircle({0, 0}, 50'000, true);
    builder.addArea({builder.addShape(drilled), {}}, {});
    builder.setProfile(builder.addShape(plate()));
    builder.setBoardThickness(240'000);
    return builder.finish();
}

/// Pixels of two pictures on one side of the vertical line at `x` that differ; those next to it do not count.
std::size_t differingBeside(const Image& a, const Image& b, std::uint32_t from, std::uint32_t to) {
    std::size_t count = 0;
    for (std::uint32_t y = 0; y < a.height; ++y) {
        for (std::uint32_t x = from; x < to; ++x) {
            count += distance(pixel(a, x, y), pixel(b, x, y)) > 8 ? 1 : 0;
        }
    }
    return count;
}

/// A circle on a picture, in pixels.
struct Circle {
    glm::vec2 centre;
    float radius;
};

std::vector<Circle> roundHoles(const Board& board, const Camera& camera) {
    const float mmPerPixel = camera.mmPerPixel(static_cast<float>(kHeight));
    const glm::vec2 middle = 0.5F * (glm::vec2(board.model.boxMin) + glm::vec2(board.model.boxMax));
    const model::ElementTable& elements = board.document->elements;
    std::vector<Circle> found;
    for (std::size_t row = 0; row < elements.size(); ++row) {
        if (elements.kind[row] == model::ElementKind::Circle && (elements.flags[row] & model::kHole) != 0) {
            const model::CircleGeometry& hole = board.document->circles[elements.geometry[row]];
            const glm::vec2 at = (toGpu(base::toDouble(hole.centre), board.model.origin) - middle) / mmPerPixel;
            const float radius = static_cast<float>(hole.diameter / 2.0 / kMm) / mmPerPixel;
            found.push_back({{kWidth / 2.0F + at.x, kHeight / 2.0F - at.y}, radius});
        }
    }
    return found;
}

/// What lies within two pixels of a circle.
void copyRim(const Image& from, const Circle& circle, Image& to) {
    for (std::uint32_t y = 0; y < from.height; ++y) {
        for (std::uint32_t x = 0; x < from.width; ++x) {
            const float away = glm::distance(glm::vec2(x, y) + 0.5F, circle.centre) - circle.radius;
            if (std::abs(away) < 2.0F) {
                const std::size_t byte = 4 * (std::size_t{y} * from.width + x);
                std::copy_n(from.rgba.begin() + static_cast<std::ptrdiff_t>(byte), 4,
                            to.rgba.begin() + static_cast<std::ptrdiff_t>(byte));
            }
        }
    }
}

Rgb bytesOf(const glm::vec3& colour) {
    const glm::vec3 bytes = glm::round(colour * 255.0F);
    return {int(bytes.r), int(bytes.g), int(bytes.b)};
}

/// Dielectrics by material, all else as its layer.
Rgb colourOf(const SectionFace& face, const Board& board) {
    const std::uint32_t rgb = face.colour.value_or(0);
    return face.colour ? Rgb{int(rgb >> 16U & 0xffU), int(rgb >> 8U & 0xffU), int(rgb & 0xffU)}
                       : bytesOf(board.styles[face.layer.row()].colour);
}

/// What a picture of a board that is cut along x at y = 0 must show of the cut.
class CutFace {
public:
    CutFace(const Board& board, const ViewSettings& settings, const Camera& camera)
        : m_start(settings.section->plane.start.x),
          m_sign(settings.section->plane.direction.x),
          m_boardFromClip(glm::inverse(glm::dmat4(camera.projection(kAspect)) * glm::dmat4(camera.view()))) {
        const std::vector<ZRange> heights = board.scene.drawnHeights(settings);
        const float faces = board.scene.drawnFaces(settings);
        for (const SectionFace& face : settings.section->faces) {
            const std::size_t layer = face.layer.row();
            const ZRange upright = heights[face.beside.isValid() ? face.beside.row() : layer];
            const ZRange z = face.isMirrored ? ZRange{faces - upright.z1, faces - upright.z0} : upright;
            QVERIFY2(face.leanFrom == 0.0 && face.leanTo == 0.0, "the sample has no laser vias");
            if (board.styles[layer].isVisible) {
                m_pieces.push_back({{face.from, glm::mix(z.z0, z.z1, face.bottom)},
                                    {face.to, glm::mix(z.z0, z.z1, face.top)},
                                    face.isInside,
                                    colourOf(face, board)});
            }
        }
        std::ranges::stable_sort(m_pieces, {}, &Piece::isInside);
    }

    struct Compared {
        std::size_t checked = 0;  ///< pixels of the cut, but for those near the edge of a piece
        std::size_t wrong = 0;    ///< of those, how many have another colour
    };
    [[nodiscard]] Compared compare(const Image& picture) const {
        Compared compared;
        for (std::uint32_t y = 1; y + 1 < kHeight; ++y) {
            for (std::uint32_t x = 1; x + 1 < kWidth; ++x) {
                if (const std::optional<Rgb> colour = colourAt(x, y)) {
                    ++compared.checked;
                    compared.wrong += distance(pixel(picture, x, y), *colour) > 2 ? 1 : 0;
                }
            }
        }
        return compared;
    }

private:
    /// None: beside the cut, or near the edge of a piece.
    [[nodiscard]] std::optional<Rgb> colourAt(std::uint32_t x, std::uint32_t y) const {
        const glm::dvec2 a = onPlane(x - 1.0, y - 1.0);
        const glm::dvec2 b = onPlane(x + 2.0, y + 2.0);
        const glm::dvec2 low = glm::min(a, b);
        const glm::dvec2 high = glm::max(a, b);
        std::optional<Rgb> colour;
        for (const Piece& piece : m_pieces) {
            const bool meets = glm::all(glm::lessThan(low, piece.high)) && glm::all(glm::greaterThan(high, piece.low));
            const bool covers = glm::all(glm::greaterThan(low, piece.low)) && glm::all(glm::lessThan(high, piece.high));
            if (meets) {
                colour = covers ? std::optional(piece.colour) : std::nullopt;
            }
        }
        return colour;
    }

    struct Piece {
        glm::dvec2 low;  ///< along the plane, upwards
        glm::dvec2 high;
        bool isInside;
        Rgb colour;
    };

    [[nodiscard]] glm::dvec2 onPlane(double x, double y) const {
        const auto at = [&](double depth) {
            const glm::dvec4 p =
                m_boardFromClip * glm::dvec4(2.0 * x / kWidth - 1.0, 2.0 * y / kHeight - 1.0, depth, 1);
            return glm::dvec3(p) / p.w;
        };
        const glm::dvec3 near = at(1.0);
        const glm::dvec3 far = at(0.5);
        const glm::dvec3 p = near + (far - near) * (near.y / (near.y - far.y));
        return {(p.x - m_start) * m_sign, p.z};
    }

    double m_start;
    double m_sign;
    glm::dmat4 m_boardFromClip;
    std::vector<Piece> m_pieces;
};

}  // namespace

class SectionPlaneTest : public QObject {
    Q_OBJECT

private slots:
    void oneSideIsGoneAndTheOtherAsItWas_data() {
        QTest::addColumn<bool>("isPanel");
        QTest::addColumn<int>("backend");
        for (const bool isPanel : {false, true}) {
            QTest::addRow("pull, %s", isPanel ? "panel" : "sample") << isPanel << int(Backend::Pull);
            QTest::addRow("impostor, %s", isPanel ? "panel" : "sample") << isPanel << int(Backend::Impostor);
            QTest::addRow("mesh, %s", isPanel ? "panel" : "sample") << isPanel << int(Backend::Mesh);
        }
    }
    void oneSideIsGoneAndTheOtherAsItWas() {
        QFETCH(bool, isPanel);
        QFETCH(int, backend);
        if (backend == int(Backend::Mesh) && !Gpu::get().device.caps().hasMeshShader) {
            QSKIP("the device has no mesh shaders");
        }
        Board board(isPanel ? panel() : sample());
        const Camera camera = board.seen(NamedView::Top, true);
        ViewSettings settings;
        settings.backend = static_cast<Backend>(backend);
        settings.background = glm::vec3(0.0F, 0.0F, 0.4F);
        const Image whole = board.draw(camera, settings);
        settings.section = board.cut({0, 1}, {0, 0});  // downwards: the right half goes
        const Image open = board.draw(camera, settings);
        constexpr std::uint32_t kMiddle = kWidth / 2;
        // With a section the inside is drawn, too: so is it in a picture of which only a strip on the right goes.
        settings.section = board.cut({20, 1}, {20, 0});
        const Image nearlyWhole = board.draw(camera, settings);
        QVERIFY(differingBeside(open, nearlyWhole, 0, kMiddle - 1) < 20);
        // Without one it is hidden. Polygons leave gaps at rims of holes, through which it was seen from straight
        // above.
        Image hidden = whole;
        for (const Circle& hole : roundHoles(board, camera)) {
            copyRim(open, hole, hidden);
        }
        QVERIFY(differingBeside(open, hidden, 0, kMiddle - 1) < 20);
        const Rgb ground = bytesOf(settings.background);
        std::size_t shown = 0;
        for (std::uint32_t y = 0; y < kHeight; ++y) {
            for (std::uint32_t x = kMiddle + 1; x < kWidth; ++x) {
                QVERIFY(distance(pixel(open, x, y), ground) <= 1);
                shown += distance(pixel(whole, x, y), ground) > 8 ? 1 : 0;
            }
        }
        QVERIFY(shown > 10000);  // there was something
    }

    void theCutHasTheColoursOfWhatLiesInIt() {
        Board board(sample());
        Camera camera = board.seen(NamedView::Iso, false);
        camera.zoom(1.3F, {0.0F, 0.0F}, kAspect);
        ViewSettings settings;
        settings.zScale = {20.0F, 3.0F};
        settings.section = board.cut({1, 0}, {0, 0});
        const Image open = board.draw(camera, settings);
        const std::vector<ZRange> heights = board.scene.drawnHeights(settings);
        const glm::mat4 clip = camera.projection(kAspect) * camera.view();
        const double pixelsPerMm = 0.5 / double(camera.mmPerPixel(kHeight));  // seen at a slant
        int checked = 0;
        std::set<std::size_t> layers;
        for (const SectionFace& face : settings.section->faces) {
            const std::size_t row = face.layer.row();
            const bool isWhole = face.bottom == 0.0F && face.top == 1.0F;
            if (!face.isInside || !isWhole || !board.styles[row].isVisible) {
                continue;
            }
            const glm::dvec2 location =
                settings.section->plane.start + 0.5 * (face.from + face.to) * settings.section->plane.direction;
            const auto at = [&](float z) {
                const glm::vec4 p = clip * glm::vec4(glm::vec2(location), z, 1.0F);
                return glm::vec2((p.x / p.w + 1.0F) * 0.5F * kWidth, (p.y / p.w + 1.0F) * 0.5F * kHeight);
            };
            const glm::vec2 low = at(heights[row].z0);
            const glm::vec2 high = at(heights[row].z1);
            const glm::vec2 middle = 0.5F * (low + high);
            const glm::vec2 inside = glm::abs(middle - glm::vec2(kWidth, kHeight) * 0.5F);
            const bool isSmall = glm::length(low - high) < 3.0F || (face.to - face.from) * pixelsPerMm < 4.0;
            if (isSmall || inside.x > kWidth * 0.49F || inside.y > kHeight * 0.49F) {
                continue;
            }
            const Rgb seen = pixel(open, std::uint32_t(middle.x), std::uint32_t(middle.y));
            QVERIFY2(distance(seen, bytesOf(board.styles[row].colour)) <= 2,
                     qPrintable(QString("layer %1: %2").arg(row).arg(describe(seen).c_str())));
            layers.insert(row);
            ++checked;
        }
        QVERIFY2(checked >= 5 && layers.size() >= 3, qPrintable(QString::number(checked)));
    }

    /// Core and prepreg as the job calls them, in the colours that they have in a section.
    void dielectricsHaveTheColoursOfTheirMaterials() {
        Board board(sample());
        auto document = std::make_shared<Document>(*board.document);
        const auto isDielectric = [](const model::StackupRow& r) { return r.type == model::LayerType::Dielectric; };
        int odd = 0;
        for (model::StackupRow& row : document->stackup.rows) {
            if (isDielectric(row)) {
                row.material.type = odd++ % 2 == 0 ? "PREPREG" : "CORE";
            }
        }
        board.document = document;
        ViewSettings settings;
        settings.zScale = {20.0F, 20.0F};
        settings.section = board.cut({1, 0}, {0, 0});
        Camera camera = board.seen(NamedView::Iso, false);
        const Image open = board.draw(camera, settings);
        std::map<std::uint32_t, int> seen;
        for (std::uint32_t y = 0; y < kHeight; ++y) {
            for (std::uint32_t x = 0; x < kWidth; ++x) {
                const Rgb colour = pixel(open, x, y);
                ++seen[std::uint32_t(colour.r) << 16U | std::uint32_t(colour.g) << 8U | std::uint32_t(colour.b)];
            }
        }
        QVERIFY2(seen[*model::colourOf(model::SectionMaterial::Core)] > 300 &&
                     seen[*model::colourOf(model::SectionMaterial::Prepreg)] > 300,
                 qPrintable(QString("%1 %2")
                                .arg(seen[*model::colourOf(model::SectionMaterial::Core)])
                                .arg(seen[*model::colourOf(model::SectionMaterial::Prepreg)])));
    }

    /// Beside its foot lies what lies beside it, above that its wall.
    void laserViasNarrowTowardsTheirTarget() {
        Board board(laserVia());
        const Camera camera = board.seen(NamedView::Iso, true);
        ViewSettings settings;
        settings.isSmoothed = false;
        settings.section = board.cut({1, 0}, {0, 0});
        const Image open = board.draw(camera, settings);
        const glm::mat4 clip = camera.projection(kAspect) * camera.view();
        const ZRange laser = board.scene.drawnHeights(settings)[3];  // 0.12 to 0.24 mm
        const auto colourAt = [&](float x, float z) {
            const glm::vec4 p = clip * glm::vec4(x, 0.0F, glm::mix(laser.z0, laser.z1, (z - 0.12F) / 0.12F), 1.0F);
            return pixel(open, std::uint32_t((p.x / p.w + 1.0F) * 0.5F * kWidth),
                         std::uint32_t((p.y / p.w + 1.0F) * 0.5F * kHeight));
        };
        const Rgb plating = bytesOf(board.styles[3].colour);
        const Rgb dielectric = colourAt(0.12F, 0.18F);
        QVERIFY(test::distance(plating, dielectric) > 8);
        const auto isAt = [&](float x, float z, const Rgb& colour) {
            const Rgb seen = colourAt(x, z);
            const bool isThere = test::distance(seen, colour) <= 2;
            if (!isThere) {
                qWarning("%s at %g %g, wanted %s", describe(seen).c_str(), double(x), double(z),
                         describe(colour).c_str());
            }
            return isThere;
        };
        for (const float side : {-1.0F, 1.0F}) {
            QVERIFY(isAt(side * 0.044F, 0.212F, plating));     // wall at the top
            QVERIFY(isAt(side * 0.046F, 0.146F, dielectric));  // beside the foot
            QVERIFY(isAt(side * 0.036F, 0.160F, plating));     // wall at the foot
        }
        QVERIFY(isAt(0.0F, 0.148F, plating));  // on the target pad
    }

    void nothingShowsThroughTheCut_data() {
        QTest::addColumn<int>("backend");
        QTest::addColumn<float>("distance");
        QTest::addColumn<float>("pitch");
        for (const Backend backend : {Backend::Pull, Backend::Mesh, Backend::Impostor}) {
            QTest::addRow("%s, near", nameOf(backend)) << int(backend) << 8.0F << -0.6F;
            QTest::addRow("%s, level", nameOf(backend)) << int(backend) << 30.0F << -0.2F;
            QTest::addRow("%s, far", nameOf(backend)) << int(backend) << 30.0F << -0.6F;
        }
    }
    /// In perspective, upright walls deep in the board are seen edge-on everywhere.
    void nothingShowsThroughTheCut() {
        QFETCH(int, backend);
        QFETCH(float, distance);
        QFETCH(float, pitch);
        if (backend == int(Backend::Mesh) && !Gpu::get().device.caps().hasMeshShader) {
            QSKIP("the device has no mesh shaders");
        }
        Board board(sample());
        ViewSettings settings;
        settings.backend = static_cast<Backend>(backend);
        settings.zScale = {3.0F, 3.0F};
        settings.section = board.cut({1, 0}, {0, 0});
        Camera camera = board.seen(NamedView::Iso, false);
        camera.setPose({{0.0F, 0.0F, 2.0F}, distance, 0.0F, pitch, false});
        const Image open = board.draw(camera, settings);
        QCOMPARE(Gpu::get().presenter.stats().backend, static_cast<Backend>(backend));
        const auto [checked, wrong] = CutFace(board, settings, camera).compare(open);
        QVERIFY2(checked > 30000 && wrong == 0, qPrintable(QString("%1 of %2").arg(wrong).arg(checked)));
    }

    void whatHasNoCounterpartIsCutWhereItIsDrawn() {
        Board board(flippedPrint());
        ViewSettings settings;
        settings.zScale = {2.0F, 2.0F};
        settings.section = board.cut({1, 0}, {0, 0});
        const auto& faces = settings.section->faces;
        const auto print = std::ranges::find(faces, model::LayerId{2}, &SectionFace::layer);
        QVERIFY(print != faces.end() && print->isMirrored);
        QCOMPARE(print->bottom, 0.0F);
        QCOMPARE(print->top, 1.0F);
        const auto copper = std::ranges::find(faces, model::LayerId{1}, &SectionFace::layer);
        QVERIFY(copper != faces.end() && !copper->isMirrored);
        Camera camera = board.seen(NamedView::Iso, false);
        camera.setPose({{0.0F, 0.0F, 0.0F}, 30.0F, 0.0F, -0.2F, false});
        const Image open = board.draw(camera, settings);
        const auto [checked, wrong] = CutFace(board, settings, camera).compare(open);
        QVERIFY2(checked > 3000 && wrong == 0, qPrintable(QString("%1 of %2").arg(wrong).arg(checked)));
    }

    void linesOfSightAreCutToo() {
        for (const bool isPanel : {false, true}) {
            Board board(isPanel ? panel() : sample());
            const Camera camera = board.seen(NamedView::Iso, isPanel);
            ViewSettings settings;
            settings.isSmoothed = false;
            settings.zScale = {20.0F, 3.0F};
            const Image whole = board.draw(camera, settings);
            settings.section = board.cut({1, 0.3}, {0, 0});
            settings.backend = Backend::Pull;
            const Image pull = board.draw(camera, settings);
            QVERIFY(greyMse(pull, whole) > 0.01);
            for (const Backend backend : {Backend::Impostor, Backend::Raster}) {
                settings.backend = backend;
                const double mse = greyMse(pull, board.draw(camera, settings));
                QCOMPARE(Gpu::get().presenter.stats().backend, backend);
                QVERIFY2(mse < 0.0005, qPrintable(QString::number(mse)));
            }
        }
    }

    void hiddenLayersAreNotInTheCut() {
        Board board(sample());
        for (LayerStyle& style : board.styles) {
            style.isVisible = false;
        }
        board.scene.setStyles(board.styles);
        ViewSettings settings;
        settings.section = board.cut({1, 0}, {0, 0});
        const Image open = board.draw(board.seen(NamedView::Iso, false), settings);
        settings.section = nullptr;
        QCOMPARE(differingPixels(open, board.draw(board.seen(NamedView::Iso, false), settings), 0), std::size_t{0});
    }

    void aLineBesideTheBoardLeavesAllOrNothing() {
        Board board(sample());
        const Camera camera = board.seen(NamedView::Iso, false);
        ViewSettings settings;
        const Image whole = board.draw(camera, settings);
        settings.section = board.cut({200, 1}, {200, 0});
        QVERIFY(settings.section->faces.empty());
        QCOMPARE(differingPixels(board.draw(camera, settings), whole, 0), std::size_t{0});
        settings.section = board.cut({-200, 1}, {-200, 0});
        const Image none = board.draw(camera, settings);
        QCOMPARE(differingPixels(none, board.draw(camera, settings), 0), std::size_t{0});
        QVERIFY(differingPixels(none, whole) > 10000);
        base::Progress progress;
        const auto index = *model::indexBoard(board.document, progress);
        QVERIFY(!makeSectionCut(*index, board.model.origin, {5, 5}, {5, 5}));
    }
};

GPU_TEST_MAIN(SectionPlaneTest)
#include "section_plane_test.moc"
