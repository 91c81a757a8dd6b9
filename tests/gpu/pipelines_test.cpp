#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>

#include "model/formats/registry.h"
#include "model/generate/job_writer.h"
#include "render/frame/frame_measures.h"
#include "render/standard/standard_model.h"
#include "tests/gpu/gpu_fixture.h"
#include "tests/locations.h"

using namespace render;
using namespace render::test;

/// The hybrid and the standard pipeline draw the same picture of the same board.
class PipelinesTest : public QObject {
    Q_OBJECT

    static constexpr std::uint32_t kWidth = 640;
    static constexpr std::uint32_t kHeight = 480;
    static constexpr float kAspect = 4.0F / 3.0F;

    struct Appearance {
        const char* name;
        NamedView view;
        bool is2d;
        float zoom;
        float explode;
    };
    static constexpr Appearance kStyles[] = {
        {"2d top", NamedView::Top, true, 1.0F, 0.0F},        {"2d bottom, 5x", NamedView::Bottom, true, 5.0F, 0.0F},
        {"top, 5x", NamedView::Top, false, 5.0F, 0.0F},      {"iso", NamedView::Iso, false, 1.0F, 0.0F},
        {"iso, 5x", NamedView::Iso, false, 5.0F, 0.0F},      {"iso, 30x", NamedView::Iso, false, 30.0F, 0.0F},
        {"iso, exploded", NamedView::Iso, false, 1.0F, 0.5F}};

    static std::shared_ptr<const model::Document> read(const std::filesystem::path& path) {
        base::Progress progress;
        auto document = model::readBoard(path, {}, progress);
        return document ? *document : nullptr;
    }

    static Image draw(BoardScene& scene, const BoardFrame& frame, const Appearance& look) {
        Camera camera;
        camera.setOrthographic(look.is2d);
        camera.fit(frame.boxMin, frame.boxMax, look.view, kAspect);
        camera.focusOnHeight(frame.boxMax.z);
        camera.zoom(look.zoom, {0.0F, 0.0F}, kAspect);
        ViewSettings settings;
        settings.is2d = look.is2d;
        settings.explode = look.explode;
        auto image = Gpu::get().presenter.render(scene, camera, settings, kWidth, kHeight);
        return image ? *image : Image{};
    }

    static Image empty() {
        BoardModel nothing;
        BoardScene scene(Gpu::get().device, nothing);
        return draw(scene, nothing, kStyles[0]);
    }

    static std::filesystem::path madeUp(const QTemporaryDir& folder) {
        const model::generate::PaperModel* like = model::generate::findPaperModel("t1");
        const std::filesystem::path path = folder.filePath("t1.tgz").toStdString();
        base::Progress progress;
        return model::generate::writeJob({like->counts, like->tracksPerTrail, 1}, path, progress)
                   ? path
                   : std::filesystem::path();
    }

private slots:
    void picturesAgree_data() {
        QTest::addColumn<QString>("board");
        QTest::newRow("sample") << locations::kSample;
        QTest::newRow("everything") << locations::kTestData + QStringLiteral("/odb/everything");
        QTest::newRow("made up") << "";
        QTest::newRow("panel") << locations::kTestData + QStringLiteral("/odb/panel");
        for (const auto& board :
             locations::boardsNamed({"kicad/StickHub.tgz", "ninevoltz_panel.tgz", "diegocoll_praxis_pdna.tgz",
                                     "lx3jl_usb3006.tgz", "paper_t1.txt"})) {
            QTest::newRow(board.filename().c_str()) << QString::fromStdString(board.string());
        }
    }
    void picturesAgree() {
        QFETCH(QString, board);
        const QTemporaryDir folder;
        const std::filesystem::path path =
            board.isEmpty() ? madeUp(folder) : std::filesystem::path(board.toStdString());
        const auto document = read(path);
        QVERIFY(document != nullptr);
        base::Progress progress;
        const auto hybrid = buildBoardModel(*document, {}, progress);
        const auto standard = buildStandardModel(*document, {}, progress);
        BoardScene hybridScene(Gpu::get().device, *hybrid);
        BoardScene standardScene(Gpu::get().device, *standard);
        hybridScene.setStyles(defaultStyles(*document));
        standardScene.setStyles(defaultStyles(*document));
        for (const Appearance& look : kStyles) {
            const Image expected = draw(standardScene, *standard, look);
            QCOMPARE(Gpu::get().presenter.stats().backend, Backend::Standard);
            const double mse = greyMse(draw(hybridScene, *hybrid, look), expected);
            qInfo() << look.name << mse;
            QVERIFY2(mse <= 0.001, look.name);
            QVERIFY2(greyMse(expected, empty()) > 0.001, look.name);
        }
    }

    /// The comparison itself sees what is missing.
    void aMissingLayerShows() {
        const auto document = read(locations::kSample);
        base::Progress progress;
        const auto hybrid = buildBoardModel(*document, {}, progress);
        BoardScene scene(Gpu::get().device, *hybrid);
        std::vector<LayerStyle> styles = defaultStyles(*document);
        scene.setStyles(styles);
        const Image whole = draw(scene, *hybrid, kStyles[0]);
        styles.back().isVisible = styles.front().isVisible = false;
        for (std::size_t row = 0; row < styles.size(); ++row) {
            styles[row].isVisible = styles[row].isVisible && !document->layers[row].isCopper();
        }
        scene.setStyles(styles);
        QVERIFY(greyMse(whole, draw(scene, *hybrid, kStyles[0])) > 0.001);
        QCOMPARE(greyMse(whole, whole), 0.0);
    }
};

GPU_TEST_MAIN(PipelinesTest)
#include "pipelines_test.moc"
