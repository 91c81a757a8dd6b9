#include <QtTest>
#include <cmath>
#include <numbers>

#include "tests/gpu/gpu_fixture.h"

using namespace render;
using namespace render::test;

/// Mono pictures are rasters of shapes: their pixels can be counted.
class RasterTest : public QObject {
    Q_OBJECT

    static constexpr std::uint32_t kPixels = 512;

    static ViewSettings mono(Backend backend) {
        ViewSettings settings;
        settings.backend = backend;
        settings.isMono = true;
        return settings;
    }

    static SyntheticBoard layer() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {0.8F, 0.2F, 0.2F});
        return board;
    }

    /// White pixels of the window (-half, half)² mm drawn on kPixels² pixels.
    static std::size_t count(const SyntheticBoard& board, float half, Backend backend) {
        Scene scene(board);
        scene.lookDown({-half, -half}, {half, half});
        return whitePixels(scene.draw(mono(backend), kPixels, kPixels));
    }

    static void addBackends() {
        QTest::addColumn<int>("backend");
        QTest::newRow("pull") << int(Backend::Pull);
        QTest::newRow("mesh") << int(Backend::Mesh);
        QTest::newRow("impostor") << int(Backend::Impostor);
    }

private slots:
    void discCoversItsArea_data() {
        QTest::addColumn<int>("backend");
        QTest::addColumn<double>("radiusPx");
        QTest::addColumn<double>("innerPx");
        for (const Backend backend : {Backend::Pull, Backend::Mesh}) {
            for (const double radius : {3.0, 10.0, 36.0, 120.0, 250.0}) {
                const char* name = backend == Backend::Pull ? "pull" : "mesh";
                QTest::addRow("%s, disc of %g px", name, radius) << int(backend) << radius << 0.0;
                QTest::addRow("%s, ring of %g px", name, radius) << int(backend) << radius << radius * 0.6;
            }
        }
    }
    /// The polygon strays at most 0.1 px from the circle, as far to the outside as to the inside, so that its area is
    /// much closer; sampling adds less than the square root of the outline.
    void discCoversItsArea() {
        QFETCH(int, backend);
        QFETCH(double, radiusPx);
        QFETCH(double, innerPx);
        SyntheticBoard board = layer();
        constexpr double kMmPerPx = 2.0 / kPixels;
        board.addDisc({0.0013F, 0.0017F}, static_cast<float>(radiusPx * kMmPerPx),
                      static_cast<float>(innerPx * kMmPerPx));
        const auto white = static_cast<double>(count(board, 1.0F, static_cast<Backend>(backend)));
        const double area = std::numbers::pi * (radiusPx * radiusPx - innerPx * innerPx);
        const double outline = 2.0 * std::numbers::pi * (radiusPx + innerPx);
        QVERIFY2(std::abs(white - area) <= 0.05 * outline + 0.5 * std::sqrt(outline),
                 qPrintable(QString("%1 pixels, area %2").arg(white).arg(area)));
    }

    void strokeCoversItsArea_data() { addBackends(); }
    void strokeCoversItsArea() {
        QFETCH(int, backend);
        SyntheticBoard board = layer();
        constexpr float kMmPerPx = 2.0F / kPixels;
        constexpr float kRadius = 20.0F;
        board.addTrack(glm::vec2(-150, -90) * kMmPerPx, glm::vec2(150, 90) * kMmPerPx, kRadius * kMmPerPx);
        const auto white = static_cast<double>(count(board, 1.0F, static_cast<Backend>(backend)));
        const double length = std::hypot(300.0, 180.0);
        const double area = std::numbers::pi * 400.0 + 40.0 * length;
        const double outline = 2.0 * (std::numbers::pi * 20.0 + length);
        QVERIFY2(std::abs(white - area) <= std::sqrt(outline) + 0.1 * 2.0 * std::numbers::pi * 20.0,
                 qPrintable(QString("%1 pixels, area %2").arg(white).arg(area)));
    }

    void arcCoversItsArea_data() {
        QTest::addColumn<int>("backend");
        QTest::addColumn<float>("sweep");
        for (const float sweep : {0.3F, -1.5F, 1.5F}) {
            QTest::addRow("pull, %g rad", static_cast<double>(sweep)) << int(Backend::Pull) << sweep;
            QTest::addRow("mesh, %g rad", static_cast<double>(sweep)) << int(Backend::Mesh) << sweep;
        }
    }
    /// Half a pen on either side of the centre line, and a half disc at each end.
    void arcCoversItsArea() {
        QFETCH(int, backend);
        QFETCH(float, sweep);
        SyntheticBoard board = layer();
        constexpr float kMmPerPx = 2.0F / kPixels;
        board.addArc({0, 0}, 150 * kMmPerPx, 0.4F, sweep, 30 * kMmPerPx);
        const auto white = static_cast<double>(count(board, 1.0F, static_cast<Backend>(backend)));
        const double length = 150.0 * std::abs(static_cast<double>(sweep));
        const double area = std::numbers::pi * 900.0 + 60.0 * length;
        const double outline = 2.0 * (std::numbers::pi * 30.0 + length);
        QVERIFY2(std::abs(white - area) <= 0.1 * outline + std::sqrt(outline),
                 qPrintable(QString("%1 pixels, area %2").arg(white).arg(area)));
    }

    void squarePenOnThePixelGridIsExact_data() { addBackends(); }
    void squarePenOnThePixelGridIsExact() {
        QFETCH(int, backend);
        SyntheticBoard board = layer();
        constexpr float kMmPerPx = 2.0F / kPixels;
        // From x = -100 - 16 to 60 + 16 and y = 40 - 16 to 40 + 16 pixels.
        board.addTrack(glm::vec2(-100, 40) * kMmPerPx, glm::vec2(60, 40) * kMmPerPx, 16 * kMmPerPx, 0.0F,
                       shader::kLetSquarePen);
        QCOMPARE(count(board, 1.0F, static_cast<Backend>(backend)), std::size_t{192 * 32});
    }

    /// The hull of two squares: a hexagon of known area.
    void slantedSquarePenCoversItsHull_data() { addBackends(); }
    void slantedSquarePenCoversItsHull() {
        QFETCH(int, backend);
        SyntheticBoard board = layer();
        constexpr float kMmPerPx = 2.0F / kPixels;
        // Edges of a slope that is no simple fraction: through the middles of few pixels, where rounding decides.
        board.addTrack(glm::vec2(-100.0F, -61.8F) * kMmPerPx, glm::vec2(100.0F, 61.8F) * kMmPerPx, 20 * kMmPerPx, 0.0F,
                       shader::kLetSquarePen);
        const auto white = static_cast<double>(count(board, 1.0F, static_cast<Backend>(backend)));
        constexpr double kArea = 40.0 * 40.0 + 40.0 * (200.0 + 123.6);
        QVERIFY2(std::abs(white - kArea) <= 20.0, qPrintable(QString("%1 pixels, area %2").arg(white).arg(kArea)));
    }

    void areaOnThePixelGridIsExactAndKeepsItsHole() {
        SyntheticBoard board;
        board.addLayer(0.0F, 0.035F, {0.8F, 0.2F, 0.2F});
        // Window 5.12 mm: 10 µm per pixel. 200 x 100 pixels with a hole of 50 x 30.
        board.addArea({{{-1000, -500}, {1000, -500}, {1000, 500}, {-1000, 500}},
                       {{-250, -150}, {-250, 150}, {250, 150}, {250, -150}}},
                      {{{0.0F, 0.0F}, {1.0F, 0.0F}, 0, 0, 0, 0, 0.0F, 0, 0.0F, 0}});
        QCOMPARE(count(board, 2.56F, Backend::Pull), std::size_t{200 * 100 - 50 * 30});
    }

    /// p' = origin + M(mirror) R p, clockwise by the angle: the tip of an L tells all of them apart.
    void areasLieAsTheirInstancesSay_data() {
        QTest::addColumn<float>("clockwise");
        QTest::addColumn<bool>("isMirrored");
        QTest::addColumn<int>("x");  // where the tip at (1.5, 0.25) mm comes to lie, in mm
        QTest::addColumn<int>("y");
        constexpr float kQuarter = std::numbers::pi_v<float> / 2.0F;
        QTest::newRow("as drawn") << 0.0F << false << 150 << 25;
        QTest::newRow("a quarter clockwise") << kQuarter << false << 25 << -150;
        QTest::newRow("mirrored") << 0.0F << true << -150 << 25;
        QTest::newRow("turned, then mirrored") << kQuarter << true << -25 << -150;
    }
    void areasLieAsTheirInstancesSay() {
        QFETCH(float, clockwise);
        QFETCH(bool, isMirrored);
        QFETCH(int, x);
        QFETCH(int, y);
        SyntheticBoard board = layer();
        board.addArea({{{0, 0}, {2000, 0}, {2000, 500}, {500, 500}, {500, 1000}, {0, 1000}}},
                      {{{0.0F, 0.0F},
                        {std::cos(clockwise), std::sin(clockwise)},
                        0,
                        0,
                        0,
                        isMirrored ? 1U : 0U,
                        0.0F,
                        0,
                        0.0F,
                        0}});
        Scene scene(board);
        scene.lookDown({-2.56F, -2.56F}, {2.56F, 2.56F});
        const Image image = scene.draw(mono(Backend::Pull), kPixels, kPixels);
        const auto at = [&](int px, int py) {
            return pixel(image, static_cast<std::uint32_t>(256 + px), static_cast<std::uint32_t>(255 - py));
        };
        QCOMPARE(at(x, y), (Rgb{255, 255, 255}));
        QCOMPARE(at(-x, -y), (Rgb{0, 0, 0}));
        QCOMPARE(whitePixels(image), std::size_t{200 * 50 + 50 * 50});
    }
};

GPU_TEST_MAIN(RasterTest)
#include "raster_test.moc"
