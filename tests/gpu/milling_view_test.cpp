// A board as fabricated: what is milled away is not there, with every back end; as designed it is.
#include <QtTest>

#include "model/solids/solids.h"
#include "tests/gpu/gpu_fixture.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using namespace render;
using namespace render::test;
using model::LayerType;

namespace {

constexpr std::uint32_t kWidth = 400;
constexpr std::uint32_t kHeight = 300;  // 4 mm beyond the board on every side, 20 pixels to the millimetre
constexpr std::array<StackLayer, 4> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 2},
                                              {"inner", LayerType::Signal, 800 * kUm, 35 * kUm, 1},
                                              {"bottom", LayerType::Signal, 0, 35 * kUm, 0},
                                              {"drill", LayerType::Drill, 0, 1'635 * kUm, 3}}};

/// 12 mm by 7 mm with a castellation in the middle of the lower edge, and texts beyond the upper one.
std::shared_ptr<const model::Document> castellatedBoard() {
    model::DocumentBuilder builder;
    addLayers(builder, kStackup);
    builder.setProfile(builder.addShape(rectangle({0, 0}, {12 * kMm, 7 * kMm})));
    builder.beginLayer(model::LayerId{0});
    builder.addArea({builder.addShape(rectangle({5 * kMm, -kMm}, {7 * kMm, 2 * kMm})), {}}, {});
    builder.addLine({{3 * kMm, 9 * kMm}, {9 * kMm, 9 * kMm}, kMm, 0}, {});
    builder.addLine({{3 * kMm, 5 * kMm}, {9 * kMm, 5 * kMm}, kMm, 0}, {});
    builder.beginLayer(model::LayerId{3});
    builder.addCircle({{6 * kMm, 0}, kMm, 900 * kUm}, flagged(model::kHole | model::kPlated));
    base::Progress progress;
    if (!model::addSolids(builder, progress)) {
        qFatal("no solids");
    }
    return builder.finish();
}

/// The board from above, at the same scale for all.
class Board {
public:
    Board() : m_document(castellatedBoard()), m_model(modelOf(*m_document)), m_scene(Gpu::get().device, m_model) {
        m_scene.setStyles(defaultStyles(*m_document));
        m_camera.setOrthographic(true);
        m_camera.fit(m_model.boxMin, m_model.boxMax, NamedView::Top, 4.0F / 3.0F);
        m_camera.fitWindow({-10.0F, -7.5F}, {10.0F, 7.5F}, m_model.boxMax.z, 4.0F / 3.0F);
    }
    Image draw(Backend backend, bool isFabricated) {
        ViewSettings settings;
        settings.backend = backend;
        settings.isFabricated = isFabricated;
        settings.background = glm::vec3(0.0F);
        return *Gpu::get().presenter.render(m_scene, m_camera, settings, kWidth, kHeight);
    }

private:
    static BoardModel modelOf(const model::Document& document) {
        base::Progress progress;
        return *buildBoardModel(document, {}, progress);
    }

    std::shared_ptr<const model::Document> m_document;
    BoardModel m_model;
    BoardScene m_scene;
    Camera m_camera;
};

/// At a location in mm from the middle of the board.
Rgb at(const Image& image, double x, double y) {
    return pixel(image, static_cast<std::uint32_t>(200.0 + 20.0 * x), static_cast<std::uint32_t>(150.0 - 20.0 * y));
}

bool isBackground(const Rgb& colour) {
    return distance(colour, {0, 0, 0}) < 8;
}

}  // namespace

class MillingViewTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsMilledAwayIsNotThere_data() {
        QTest::addColumn<Backend>("backend");
        const auto& caps = Gpu::get().device.caps();
        for (const Backend backend : {Backend::Mesh, Backend::Pull, Backend::Impostor, Backend::Raster}) {
            const bool isThere =
                (backend != Backend::Mesh || caps.hasMeshShader) && (backend != Backend::Raster || caps.hasAtomic64);
            if (isThere) {
                QTest::newRow(nameOf(backend)) << backend;
            }
        }
    }
    void whatIsMilledAwayIsNotThere() {
        QFETCH(Backend, backend);
        Board board;
        const Image designed = board.draw(backend, false);
        const Image fabricated = board.draw(backend, true);
        QVERIFY(!isBackground(at(designed, 0.0, 5.5)));  // the text beyond the board
        QVERIFY(isBackground(at(fabricated, 0.0, 5.5)));
        QVERIFY(!isBackground(at(designed, 0.8, -4.0)));  // the pad, outside
        QVERIFY(isBackground(at(fabricated, 0.8, -4.0)));
        QVERIFY(isBackground(at(fabricated, 0.0, -3.3)));              // one sees through the half hole
        QCOMPARE(at(fabricated, 0.8, -2.5), at(designed, 0.8, -2.5));  // the pad, inside
        QCOMPARE(at(fabricated, 0.0, 1.5), at(designed, 0.0, 1.5));    // what is not milled
        QVERIFY(!isBackground(at(fabricated, 0.0, 1.5)));
    }
};

GPU_TEST_MAIN(MillingViewTest)
#include "milling_view_test.moc"
