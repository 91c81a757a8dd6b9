#include <QtTest>

#include "model/formats/registry.h"
#include "tests/gpu/gpu_fixture.h"
#include "tests/locations.h"

using namespace render;
using namespace render::test;

/// The bundled board through the whole pipeline.
class SampleBoardTest : public QObject {
    Q_OBJECT

    std::shared_ptr<const model::Document> m_document;
    std::unique_ptr<BoardModel> m_model;
    std::unique_ptr<BoardScene> m_scene;

    Image draw(const Camera& camera, Backend backend, const ViewSettings& how) {
        ViewSettings settings = how;
        settings.backend = backend;
        auto image = Gpu::get().presenter.render(*m_scene, camera, settings, 800, 600);
        return image ? std::move(*image) : Image{};
    }

private slots:
    void initTestCase() {
        base::Progress progress;
        auto document = model::readBoard(locations::kSample, {}, progress);
        QVERIFY(document);
        m_document = *document;
        auto model = buildBoardModel(*m_document, {}, progress);
        QVERIFY(model);
        m_model = std::make_unique<BoardModel>(std::move(*model));
        m_scene = std::make_unique<BoardScene>(Gpu::get().device, *m_model);
        m_scene->setStyles(defaultStyles(*m_document));
    }
    void cleanupTestCase() { m_scene.reset(); }

    void meshAndPullAgree_data() {
        QTest::addColumn<int>("view");
        QTest::addColumn<float>("zoom");
        QTest::addColumn<bool>("is2d");
        QTest::newRow("top") << int(NamedView::Top) << 1.0F << false;
        QTest::newRow("bottom") << int(NamedView::Bottom) << 1.0F << false;
        QTest::newRow("iso") << int(NamedView::Iso) << 1.0F << false;
        QTest::newRow("iso, close") << int(NamedView::Iso) << 6.0F << false;
        QTest::newRow("inside the board") << int(NamedView::Iso) << 300.0F << false;
        QTest::newRow("2d") << int(NamedView::Top) << 3.0F << true;
    }
    void meshAndPullAgree() {
        if (!Gpu::get().device.caps().hasMeshShader) {
            QSKIP("the device has no mesh shaders");
        }
        QFETCH(int, view);
        QFETCH(float, zoom);
        QFETCH(bool, is2d);
        Camera camera;
        camera.setOrthographic(is2d);
        camera.fit(m_model->boxMin, m_model->boxMax, static_cast<NamedView>(view), 4.0F / 3.0F);
        camera.zoom(zoom, {0.1F, 0.05F}, 4.0F / 3.0F);
        ViewSettings how;
        how.is2d = is2d;
        const Image pull = draw(camera, Backend::Pull, how);
        const Image mesh = draw(camera, Backend::Mesh, how);
        QCOMPARE(pull.rgba.size(), std::size_t{800 * 600 * 4});
        const std::size_t differing = differingPixels(pull, mesh);
        QVERIFY2(differing <= 48, qPrintable(QString::number(differing)));  // 0.01 %
    }

    /// Fitted from above the board fills the picture in one direction, and its centre is no background.
    void boardFillsTheFittedView() {
        Camera camera;
        camera.fit(m_model->boxMin, m_model->boxMax, NamedView::Top, 4.0F / 3.0F);
        ViewSettings how;
        how.background = glm::vec3(0.0F);
        const Image image = draw(camera, Backend::Auto, how);
        std::size_t drawn = 0;
        for (std::uint32_t y = 0; y < image.height; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                drawn += pixel(image, x, y) == Rgb{} ? 0 : 1;
            }
        }
        const glm::vec3 size = m_model->boxMax - m_model->boxMin;
        const double scale = std::min(800.0 / static_cast<double>(size.x), 600.0 / static_cast<double>(size.y));
        const double board = static_cast<double>(size.x * size.y) * scale * scale;
        QVERIFY2(static_cast<double>(drawn) > 0.75 * board, qPrintable(QString::number(drawn)));
        QVERIFY2(static_cast<double>(drawn) < 1.05 * board, qPrintable(QString::number(drawn)));
        QVERIFY(distance(pixel(image, 400, 300), Rgb{}) > 30);
    }
};

GPU_TEST_MAIN(SampleBoardTest)
#include "sample_board_test.moc"
