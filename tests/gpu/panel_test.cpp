// Panels: a step is on the device once and drawn wherever it is placed. Judged by boards that hold the same shapes
// flat.
#include <QtTest>

#include "model/board/copies.h"
#include "model/board/document_builder.h"
#include "model/text/whole_file.h"
#include "render/frame/png.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;
using model::Document;
using model::DocumentBuilder;
using model::ElementKind;
using model::LayerId;
using model::Placement;
using model::Point;

namespace {

constexpr model::Nm kMm = 1'000'000;

/// mask over top, core, bottom, and holes through all; turned over, top and bottom change places and the mask, which
/// has no counterpart, lies below.
void addLayers(DocumentBuilder& builder) {
    struct Row {
        const char* name;
        model::LayerType type;
        model::LayerSide side;
        model::Nm z;
        model::Nm thickness;
    };
    for (const Row& row : {Row{"mask", model::LayerType::SolderMask, model::LayerSide::Top, 1600, 25},
                           Row{"top", model::LayerType::Signal, model::LayerSide::Top, 1500, 100},
                           Row{"bottom", model::LayerType::Signal, model::LayerSide::Bottom, 0, 100},
                           Row{"drill", model::LayerType::Drill, model::LayerSide::Through, 0, 1600}}) {
        model::Layer layer;
        layer.name = row.name;
        layer.type = row.type;
        layer.side = row.side;
        layer.z = row.z * 1000;
        layer.thickness = row.thickness * 1000;
        builder.addLayer(layer);
    }
    builder.layers()[1].opposite = LayerId{2};
    builder.layers()[2].opposite = LayerId{1};
    builder.layers()[3].opposite = LayerId{3};
    builder.setBoardThickness(1'600'000);
}

/// Every kind of element, without any symmetry, on about 10 x 8 mm around (3, 2).
std::shared_ptr<const Document> card() {
    DocumentBuilder builder;
    addLayers(builder);
    model::ShapeSketch corner;
    corner.addPolygon(
        std::array<Point, 6>{{{0, 0}, {3 * kMm, 0}, {3 * kMm, kMm}, {kMm, kMm}, {kMm, 2 * kMm}, {0, 2 * kMm}}}, false);
    const model::ShapeId shape = builder.addShape(corner);
    builder.beginLayer(LayerId{0});
    builder.addArea({shape, {{-2 * kMm, -kMm}, 30.0, false}}, {});
    builder.beginLayer(LayerId{1});
    builder.addLine({{-kMm, 0}, {4 * kMm, 3 * kMm}, 400'000, 0}, {});
    builder.addArc(
        {{{5 * kMm, 0}, {5 * kMm, 2 * kMm}, model::EdgeKind::ArcCounterClockwise}, {7 * kMm, 2 * kMm}, 300'000}, {});
    builder.addArea({shape, {{kMm, 4 * kMm}, 0.0, true}}, {});
    builder.beginLayer(LayerId{2});
    builder.addTrail(std::array<model::PathNode, 3>{{{{0, -kMm}, {}, model::EdgeKind::Line},
                                                     {{3 * kMm, -kMm}, {4 * kMm, -kMm}, model::EdgeKind::ArcClockwise},
                                                     {{4 * kMm, 0}, {}, model::EdgeKind::Line}}},
                     500'000, {});
    builder.beginLayer(LayerId{3});
    DocumentBuilder::Origin hole;
    hole.flags = model::kHole | model::kPlated;
    builder.addCircle({{6 * kMm, 4 * kMm}, 1'200'000, 1'000'000}, hole);
    return builder.finish();
}

/// All boards are drawn around the middle of this.
void addOutline(DocumentBuilder& builder) {
    model::ShapeSketch outline;
    outline.addPolygon(
        std::array<Point, 4>{
            {{-26 * kMm, -20 * kMm}, {26 * kMm, -20 * kMm}, {26 * kMm, 20 * kMm}, {-26 * kMm, 20 * kMm}}},
        false);
    builder.setProfile(builder.addShape(outline));
}

struct Location {
    Placement placement;
    bool isFlipped = false;
};

std::shared_ptr<const Document> panelOf(const std::shared_ptr<const Document>& step,
                                        const std::vector<Location>& locations) {
    DocumentBuilder builder;
    addLayers(builder);
    builder.beginLayer(LayerId{1});
    builder.addLine({{-20 * kMm, -14 * kMm}, {20 * kMm, -14 * kMm}, kMm, 0}, {});
    addOutline(builder);
    const std::uint32_t row = builder.addStep(step);
    for (const Location& location : locations) {
        builder.addInstance({row, location.placement, location.isFlipped});
    }
    return builder.finish();
}

/// A panel of cards turned by a quarter and by an odd angle, mirrored, flipped, and a card inside a flipped inner
/// panel.
std::shared_ptr<const Document> panel() {
    const auto inner = panelOf(card(), {{{{0, 0}, 45.0, false}, false}, {{{12 * kMm, 0}, 0.0, true}, true}});
    return panelOf(inner, {{{{-12 * kMm, 8 * kMm}, 90.0, false}, false},
                           {{{12 * kMm, -4 * kMm}, 20.0, true}, true},
                           {{{14 * kMm, 12 * kMm}, 180.0, true}, false}});
}

/// Adds one element of `from` where `placement` puts it.
void addPlaced(DocumentBuilder& builder, const Document& from, std::size_t row, const Placement& placement,
               model::ShapeId shape) {
    DocumentBuilder::Origin origin;
    origin.flags = from.elements.flags[row];
    const std::uint32_t geometry = from.elements.geometry[row];
    switch (from.elements.kind[row]) {
        case ElementKind::Line: {
            model::LineGeometry line = from.lines[geometry];
            line.a = placement.apply(line.a);
            line.b = placement.apply(line.b);
            builder.addLine(line, origin);
            break;
        }
        case ElementKind::Arc: {
            model::ArcGeometry arc = from.arcs[geometry];
            arc.node = model::placed(arc.node, placement);
            arc.end = placement.apply(arc.end);
            builder.addArc(arc, origin);
            break;
        }
        case ElementKind::Circle: {
            model::CircleGeometry circle = from.circles[geometry];
            circle.centre = placement.apply(circle.centre);
            builder.addCircle(circle, origin);
            break;
        }
        case ElementKind::Trail: {
            std::vector<model::PathNode> nodes;
            for (const model::PathNode& node : from.nodesOf(from.trails[geometry])) {
                nodes.push_back(model::placed(node, placement));
            }
            builder.addTrail(nodes, from.trails[geometry].width, origin);
            break;
        }
        case ElementKind::Area:
            builder.addArea({shape, placement.after(from.areas[geometry].placement)}, origin);
            break;
    }
}

/// The same board without copies. The flipped mask gets a layer of its own below the board.
std::shared_ptr<const Document> flattened(const Document& board) {
    DocumentBuilder builder;
    addLayers(builder);
    model::Layer below = builder.layers()[0];
    below.z = 1'600'000 - below.z - below.thickness;
    builder.addLayer(below);
    model::ShapeSketch sketch;
    const model::StepTree tree = model::unfoldCopies(board);
    const Document& last = *tree.steps.back();
    for (const model::Contour& contour : last.shapes.contoursOf(model::ShapeId{0})) {
        sketch.beginContour(contour.isHole);
        for (const model::PathNode& node : last.shapes.nodesOf(contour)) {
            sketch.addNode(node);
        }
    }
    const model::ShapeId shape = builder.addShape(sketch);
    addOutline(builder);
    const LayerId whenFlipped[] = {LayerId{4}, LayerId{2}, LayerId{1}, LayerId{3}};
    for (std::size_t onto = 0; onto < 5; ++onto) {
        builder.beginLayer(LayerId{onto});
        for (const model::StepCopy& copy : tree.copies) {
            const Document& step = *tree.steps[copy.step];
            for (std::size_t row = 0; row < step.elements.size(); ++row) {
                const LayerId from = step.elements.layer[row];
                if ((copy.isFlipped ? whenFlipped[from.row()] : from) == LayerId{onto}) {
                    addPlaced(builder, step, row, copy.placement, shape);
                }
            }
        }
    }
    return builder.finish();
}

BoardModel modelOf(const Document& document) {
    base::Progress progress;
    return std::move(*buildBoardModel(document, {}, progress));
}

std::vector<LayerStyle> styles(std::size_t layers) {
    const LayerStyle kAll[] = {{{0.2F, 0.7F, 0.3F}, 0.6F, true},
                               {{0.8F, 0.3F, 0.2F}, 1.0F, true},
                               {{0.2F, 0.4F, 0.8F}, 1.0F, true},
                               {{0.7F, 0.5F, 0.3F}, 1.0F, true},
                               {{0.2F, 0.7F, 0.3F}, 0.6F, true}};
    return {kAll, kAll + layers};
}

struct Drawn {
    BoardModel model;
    BoardScene scene;

    explicit Drawn(const Document& document, std::uint64_t listBytes = 1 << 20)
        : model(modelOf(document)), scene(Gpu::get().device, model, listBytes) {
        scene.setStyles(styles(model.layers.size()));
    }

    Image draw(const ViewSettings& settings, NamedView view, float zoom = 1.0F) {
        Camera camera;
        camera.setOrthographic(settings.is2d);
        camera.fit({-24.0F, -18.0F, 0.0F}, {26.0F, 22.0F, 1.6F}, view, 4.0F / 3.0F);
        camera.zoom(zoom, {0.3F, 0.2F}, 4.0F / 3.0F);
        auto image = Gpu::get().presenter.render(scene, camera, settings, 640, 480);
        return std::move(*image);
    }
};

}  // namespace

class PanelTest : public QObject {
    Q_OBJECT

    static void keep(const Image& image, const std::string& path) {
        const auto png = encodePng(image);
        QVERIFY(png);
        QVERIFY(model::writeWholeFile(path, *png));
    }

    static void compare(const Image& a, const Image& b, std::size_t most) {
        const std::size_t differing = differingPixels(a, b, 60);
        QVERIFY2(differing <= most, qPrintable(QString::number(differing)));
    }

private slots:
    void copiesLookLikeShapesAtTheSamePlace_data() {
        QTest::addColumn<int>("backend");
        QTest::addColumn<int>("view");
        QTest::addColumn<bool>("is2d");
        QTest::addColumn<float>("zoom");
        for (const Backend backend : {Backend::Pull, Backend::Mesh, Backend::Impostor, Backend::Raster}) {
            const char* name = nameOf(backend);
            QTest::addRow("%s, top", name) << int(backend) << int(NamedView::Top) << true << 1.0F;
            QTest::addRow("%s, bottom", name) << int(backend) << int(NamedView::Bottom) << true << 1.0F;
            QTest::addRow("%s, iso", name) << int(backend) << int(NamedView::Iso) << false << 1.0F;
            QTest::addRow("%s, near", name) << int(backend) << int(NamedView::Iso) << false << 6.0F;
        }
    }
    /// A turned disc is a polygon with its corners elsewhere, so outlines may differ by 0.3 px; no pad is as small as
    /// 150 px.
    void copiesLookLikeShapesAtTheSamePlace() {
        QFETCH(int, backend);
        QFETCH(int, view);
        QFETCH(bool, is2d);
        QFETCH(float, zoom);
        if (static_cast<Backend>(backend) == Backend::Mesh && !Gpu::get().device.caps().hasMeshShader) {
            QSKIP("the device has no mesh shaders");
        }
        const auto document = panel();
        Drawn copies(*document);
        Drawn flat(*flattened(*document));
        QCOMPARE(copies.model.origin, flat.model.origin);
        ViewSettings settings;
        settings.backend = static_cast<Backend>(backend);
        settings.is2d = is2d;
        const Image image = copies.draw(settings, static_cast<NamedView>(view), zoom);
        QVERIFY(differingPixels(image, Drawn(*panelOf(card(), {})).draw(settings, static_cast<NamedView>(view), zoom)) >
                5000);
        if (qEnvironmentVariableIsSet("COPPERSCOPE_KEEP_PICTURES")) {
            const std::string name = qgetenv("COPPERSCOPE_KEEP_PICTURES").toStdString() + "/" + QTest::currentDataTag();
            keep(image, name + " copies.png");
            keep(flat.draw(settings, static_cast<NamedView>(view), zoom), name + " flat.png");
        }
        compare(image, flat.draw(settings, static_cast<NamedView>(view), zoom), 150);
    }

    void fewListsDrawTheSamePicture() {
        const auto document = panel();
        Drawn together(*document);
        Drawn oneByOne(*document, 1);
        QVERIFY(oneByOne.scene.gpuBytes() < together.scene.gpuBytes());
        ViewSettings settings;
        settings.backend = Backend::Pull;
        compare(together.draw(settings, NamedView::Iso), oneByOne.draw(settings, NamedView::Iso), 0);
    }

    void geometryDoesNotGrowWithTheNumberOfCopies() {
        std::vector<Location> locations;
        for (int i = 0; i < 400; ++i) {
            locations.push_back({{{(i % 20) * 12 * kMm, (i / 20) * 10 * kMm}, 0.0, false}, false});
        }
        const auto one = card();
        const Drawn single(*panelOf(one, {locations[0]}));
        const Drawn many(*panelOf(one, locations));
        QCOMPARE(many.model.copies.size(), std::size_t{401});
        QCOMPARE(many.scene.geometryBytes(), single.scene.geometryBytes());
        QCOMPARE(many.model.steps.size(), std::size_t{1});
        QCOMPARE(many.model.steps[0].lets.size(), single.model.steps[0].lets.size());
        QVERIFY(many.scene.gpuBytes() <= many.scene.geometryBytes() + (1 << 20));
    }

    void copiesOutOfViewAreLeftOutAndNothingElse() {
        Drawn board(*panel());
        for (const float zoom : {1.0F, 5.0F, 25.0F}) {
            ViewSettings settings;
            settings.backend = Backend::Pull;
            const Image culled = board.draw(settings, NamedView::Iso, zoom);
            settings.cull = false;
            const std::size_t missing = differingPixels(culled, board.draw(settings, NamedView::Iso, zoom), 150);
            QVERIFY2(missing <= 4, qPrintable(QString::number(missing)));
        }
    }

    void highlightingAnElementOfAStepLightsItUpInAllCopies() {
        Drawn board(*panelOf(card(), {{{{-10 * kMm, 0}, 0.0, false}, false}, {{{8 * kMm, 0}, 0.0, false}, false}}));
        ViewSettings settings;
        settings.is2d = true;
        const Image before = board.draw(settings, NamedView::Top);
        board.scene.setStates(statesOf(std::array{model::ElementId{1}}), 1);
        const Image after = board.draw(settings, NamedView::Top);
        std::size_t left = 0;
        std::size_t right = 0;
        for (std::uint32_t y = 0; y < after.height; ++y) {
            for (std::uint32_t x = 0; x < after.width; ++x) {
                (x < after.width / 2 ? left : right) += distance(pixel(before, x, y), pixel(after, x, y)) > 20 ? 1 : 0;
            }
        }
        QVERIFY2(left > 100 && right > 100, qPrintable(QString("%1 %2").arg(left).arg(right)));
    }
};

GPU_TEST_MAIN(PanelTest)
#include "panel_test.moc"
