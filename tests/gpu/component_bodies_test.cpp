// Bodies of components as they are drawn: in the colours of what they are made of, on the right side of every copy,
// with shadows around them.
#include <QtTest>

#include "model/board/document_builder.h"
#include "model/solids/bodies.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;
using model::Document;
using model::DocumentBuilder;
using model::LayerId;
using model::LayerSide;
using model::LayerType;
using model::Nm;
using model::Point;

namespace {

constexpr Nm kMm = 1'000'000;

/// Top and bottom copper.
void addLayers(DocumentBuilder& builder) {
    for (const LayerSide side : {LayerSide::Top, LayerSide::Bottom}) {
        model::Layer layer;
        layer.type = LayerType::Signal;
        layer.side = side;
        layer.z = side == LayerSide::Top ? 1'500'000 : 0;
        layer.thickness = 100'000;
        builder.addLayer(layer);
    }
    builder.layers()[0].opposite = LayerId{1};
    builder.layers()[1].opposite = LayerId{0};
    builder.setBoardThickness(1'600'000);
}

/// 12 by 10 mm of copper on both sides, and in the middle of the top a ceramic capacitor of 5.25 by 3.4 mm.
std::shared_ptr<const Document> card() {
    DocumentBuilder builder;
    addLayers(builder);
    model::ShapeSketch plane;
    plane.addPolygon(
        std::array<Point, 4>{{{-6 * kMm, -5 * kMm}, {6 * kMm, -5 * kMm}, {6 * kMm, 5 * kMm}, {-6 * kMm, 5 * kMm}}},
        false);
    const model::ShapeId shape = builder.addShape(plane);
    for (const std::size_t layer : {0U, 1U}) {
        builder.beginLayer(LayerId{layer});
        builder.addArea({shape, {}}, {});
    }
    model::ShapeSketch pad;
    pad.addPolygon(
        std::array<Point, 4>{{{-3 * kMm, -2 * kMm}, {-2 * kMm, -2 * kMm}, {-2 * kMm, 2 * kMm}, {-3 * kMm, 2 * kMm}}},
        false);
    const model::ShapeId left = builder.addShape(pad);
    model::PackagePin pins[2];
    pins[0] = {{}, model::PinKind::Surface, {-5 * kMm / 2, 0}, left};
    pins[1] = {{}, model::PinKind::Surface, {5 * kMm / 2, 0}, {}};
    model::Component component;
    component.refdes = "C1";
    component.height = 2 * kMm;
    component.package = builder.addPackage({}, pins);
    builder.addComponent(std::move(component), {});
    model::addBodies(builder, {2 * kMm, 2 * kMm});
    return builder.finish();
}

/// An upright copy on the left and a flipped one on the right.
std::shared_ptr<const Document> panel() {
    DocumentBuilder builder;
    addLayers(builder);
    model::ShapeSketch outline;
    outline.addPolygon(
        std::array<Point, 4>{{{-16 * kMm, -8 * kMm}, {16 * kMm, -8 * kMm}, {16 * kMm, 8 * kMm}, {-16 * kMm, 8 * kMm}}},
        false);
    builder.setProfile(builder.addShape(outline));
    model::addBodies(builder, {2 * kMm, 2 * kMm});
    const std::uint32_t step = builder.addStep(card());
    builder.addInstance({step, {{-8 * kMm, 0}, 0.0, false}, false});
    builder.addInstance({step, {{8 * kMm, 0}, 0.0, true}, true});
    return builder.finish();
}

class Drawn {
public:
    explicit Drawn(const Document& document) : Drawn(modelOf(document)) {}

    /// Without shadows: as if the bodies cast none.
    static Drawn withoutShadows(const Document& document) { return Drawn(unshadowed(modelOf(document))); }

    Image draw(Backend backend, NamedView view, bool hasBodies) {
        ViewSettings settings;
        settings.backend = backend;
        return draw(settings, view, hasBodies);
    }
    Image draw(const ViewSettings& settings, NamedView view, bool hasBodies) {
        std::vector<LayerStyle> styles(4, {{0.2F, 0.4F, 0.8F}, 1.0F, true});
        styles[2].isVisible = styles[3].isVisible = hasBodies;
        m_scene.setStyles(styles);
        auto image = Gpu::get().presenter.render(m_scene, cameraFor(view), settings, kWidth, kHeight);
        return std::move(*image);
    }
    /// The copper of the top, in both copies.
    void highlightTop() {
        const model::ElementId plane{0};
        m_scene.setStates(statesOf({&plane, 1}), 1);
    }

    /// The colour in which a location on the face of the board is drawn.
    static Rgb at(const Image& image, NamedView view, glm::vec2 location) {
        const Camera camera = cameraFor(view);
        const float z = view == NamedView::Top ? 1.6F : 0.0F;
        const glm::vec4 clip =
            camera.projection(float(kWidth) / kHeight) * camera.view() * glm::vec4(location, z, 1.0F);
        const glm::vec2 pixels = (glm::vec2(clip) / clip.w + 1.0F) / 2.0F * glm::vec2(kWidth, kHeight);
        return pixel(image, static_cast<std::uint32_t>(pixels.x), static_cast<std::uint32_t>(pixels.y));
    }

private:
    static constexpr std::uint32_t kWidth = 640;
    static constexpr std::uint32_t kHeight = 480;

    explicit Drawn(BoardModel model) : m_model(std::move(model)), m_scene(Gpu::get().device, m_model, 1 << 20) {}

    static BoardModel modelOf(const Document& document) {
        base::Progress progress;
        return std::move(*buildBoardModel(document, {}, progress));
    }
    static BoardModel unshadowed(BoardModel model) {
        model.shadows = {};
        for (BoardModel& step : model.steps) {
            step.shadows = {};
        }
        return model;
    }
    static Camera cameraFor(NamedView view) {
        Camera camera;
        camera.setOrthographic(true);
        camera.fit({-16.0F, -8.0F, 0.0F}, {16.0F, 8.0F, 1.6F}, view, float(kWidth) / kHeight);
        return camera;
    }

    BoardModel m_model;
    BoardScene m_scene;
};

/// What a layer of bodies changes of a picture, left and right of its middle.
struct Change {
    std::size_t left = 0;
    std::size_t right = 0;
};

Change changeOf(const Image& with, const Image& without) {
    Change change;
    for (std::uint32_t y = 0; y < with.height; ++y) {
        for (std::uint32_t x = 0; x < with.width; ++x) {
            const bool differs = distance(pixel(with, x, y), pixel(without, x, y)) > 20;
            (x < with.width / 2 ? change.left : change.right) += differs ? 1 : 0;
        }
    }
    return change;
}

/// Beside the body of the upright copy, and of the flipped one; and where the shadow of neither reaches.
constexpr glm::vec2 kBesideUpright{-8.0F, 2.1F};
constexpr glm::vec2 kBesideFlipped{8.0F, 2.1F};
constexpr glm::vec2 kFarFromBoth{-8.0F, 4.5F};

int sumOf(const Rgb& colour) {
    return colour.r + colour.g + colour.b;
}

void addBackends() {
    QTest::addColumn<int>("backend");
    for (const Backend backend : {Backend::Pull, Backend::Mesh, Backend::Impostor, Backend::Raster}) {
        QTest::addRow("%s", nameOf(backend)) << int(backend);
    }
}

bool canDraw(Backend backend) {
    return backend != Backend::Mesh || Gpu::get().device.caps().hasMeshShader;
}

}  // namespace

class ComponentBodiesTest : public QObject {
    Q_OBJECT

private slots:
    void bodiesOfFlippedCopiesAreOnTheOtherSide_data() { addBackends(); }
    void bodiesOfFlippedCopiesAreOnTheOtherSide() {
        QFETCH(int, backend);
        const auto with = static_cast<Backend>(backend);
        if (!canDraw(with)) {
            QSKIP("the device has no mesh shaders");
        }
        Drawn board(*panel());
        const Change above = changeOf(board.draw(with, NamedView::Top, true), board.draw(with, NamedView::Top, false));
        QVERIFY2(above.left > 1000 && above.right == 0, qPrintable(QString("%1 %2").arg(above.left).arg(above.right)));
        // Seen from below, left and right change places.
        const Change below =
            changeOf(board.draw(with, NamedView::Bottom, true), board.draw(with, NamedView::Bottom, false));
        QVERIFY2(below.left > 1000 && below.right == 0, qPrintable(QString("%1 %2").arg(below.left).arg(below.right)));
    }

    void bodiesDarkenTheBoardAroundThem_data() { addBackends(); }
    void bodiesDarkenTheBoardAroundThem() {
        QFETCH(int, backend);
        const auto with = static_cast<Backend>(backend);
        if (!canDraw(with)) {
            QSKIP("the device has no mesh shaders");
        }
        Drawn board(*panel());
        for (const NamedView view : {NamedView::Top, NamedView::Bottom}) {
            const Image shaded = board.draw(with, view, true);
            const Image bare = board.draw(with, view, false);
            const bool isTop = view == NamedView::Top;
            const glm::vec2 beside = isTop ? kBesideUpright : kBesideFlipped;
            const Rgb dark = Drawn::at(shaded, view, beside);
            QVERIFY2(10 * sumOf(dark) < 9 * sumOf(Drawn::at(bare, view, beside)), describe(dark).c_str());
            for (const glm::vec2 bright : {isTop ? kBesideFlipped : kBesideUpright, kFarFromBoth}) {
                QCOMPARE(describe(Drawn::at(shaded, view, bright)), describe(Drawn::at(bare, view, bright)));
            }
            const Rgb expected = Drawn::at(board.draw(Backend::Pull, view, true), view, beside);
            QVERIFY2(distance(dark, expected) <= 2, describe(expected).c_str());
        }
    }

    void bodiesThatAreNotShownDarkenNothing() {
        Drawn board(*panel());
        Drawn unshadowed = Drawn::withoutShadows(*panel());
        for (const NamedView view : {NamedView::Top, NamedView::Bottom, NamedView::Iso}) {
            QVERIFY(board.draw(Backend::Pull, view, false).rgba == unshadowed.draw(Backend::Pull, view, false).rgba);
            QVERIFY(board.draw(Backend::Pull, view, true).rgba != unshadowed.draw(Backend::Pull, view, true).rgba);
        }
        ViewSettings settings;
        settings.backend = Backend::Pull;
        settings.is2d = true;
        QVERIFY(board.draw(settings, NamedView::Top, true).rgba ==
                unshadowed.draw(settings, NamedView::Top, true).rgba);
        settings.is2d = false;
        settings.explode = 0.5F;
        QVERIFY(board.draw(settings, NamedView::Iso, true).rgba ==
                unshadowed.draw(settings, NamedView::Iso, true).rgba);
    }

    void whatIsHighlightedKeepsItsColour() {
        Drawn board(*panel());
        board.highlightTop();
        const Image with = board.draw(Backend::Pull, NamedView::Top, true);
        const Image without = board.draw(Backend::Pull, NamedView::Top, false);
        QCOMPARE(describe(Drawn::at(with, NamedView::Top, kBesideUpright)),
                 describe(Drawn::at(without, NamedView::Top, kBesideUpright)));
    }

    void capacitorsAreBrownWithMetalEnds() {
        Drawn board(*panel());
        const Image image = board.draw(Backend::Pull, NamedView::Top, true);
        std::size_t brown = 0;
        std::size_t metal = 0;
        for (std::uint32_t y = 0; y < image.height; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const Rgb at = pixel(image, x, y);
                brown += at.r > at.b + 50 ? 1 : 0;
                metal += at.r > 150 && std::abs(at.r - at.b) < 20 ? 1 : 0;
            }
        }
        QVERIFY2(brown > 500, qPrintable(QString::number(brown)));
        QVERIFY2(metal > 500, qPrintable(QString::number(metal)));
    }
};

GPU_TEST_MAIN(ComponentBodiesTest)
#include "component_bodies_test.moc"
