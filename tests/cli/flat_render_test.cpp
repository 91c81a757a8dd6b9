#include <png.h>

#include <QTemporaryDir>
#include <QtTest>
#include <set>

#include "tests/cli/program.h"

using program::copperscope;
using program::Outcome;

namespace {

constexpr int kWidth = 300;
constexpr int kHeight = 200;

/// Four bytes per pixel; empty if it is no picture of that size.
std::vector<png_byte> readPng(const QString& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    std::vector<png_byte> pixels(std::size_t{4} * kWidth * kHeight);
    if (png_image_begin_read_from_file(&image, path.toLocal8Bit().constData()) == 0) {
        return {};
    }
    image.format = PNG_FORMAT_RGBA;
    const bool isRight = image.width == kWidth && image.height == kHeight &&
                         png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0;
    png_image_free(&image);
    return isRight ? pixels : std::vector<png_byte>();
}

}  // namespace

/// `render` of flat pictures, on a machine without a Vulkan driver.
class FlatRenderTest : public QObject {
    Q_OBJECT

private slots:
    void flatPicturesAreThoseOfTheDevice_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addRow("top") << QStringList{"--mode", "2d"};
        QTest::addRow("bottom") << QStringList{"--mode", "2d", "--view", "bottom"};
        QTest::addRow("window") << QStringList{"--window", "10,10,50,40"};
        QTest::addRow("net") << QStringList{"--mode", "2d", "--net", "GND"};
        QTest::addRow("without background") << QStringList{"--mode", "2d", "--transparent"};
    }

    void flatPicturesAreThoseOfTheDevice() {
        QFETCH(QStringList, options);
        const std::vector<png_byte> alone = draw(options, withoutDriver());
        const std::vector<png_byte> byDevice = draw(options + QStringList{"--backend", "impostor"}, {});
        QVERIFY(!alone.empty() && !byDevice.empty());
        int differing = 0;
        std::set<std::uint32_t> colours;
        for (std::size_t i = 0; i < alone.size(); i += 4) {
            bool isOther = false;
            for (std::size_t part = i; part < i + 4; ++part) {
                isOther = isOther || std::abs(alone[part] - byDevice[part]) > 2;
            }
            differing += isOther ? 1 : 0;
            colours.insert(alone[i] | std::uint32_t{alone[i + 1]} << 8U | std::uint32_t{alone[i + 2]} << 16U);
        }
        QVERIFY2(differing <= 20, qPrintable(QString::number(differing)));
        QVERIFY(colours.size() > 20);
    }

    void whatTakesADeviceSaysThatThereIsNone_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addRow("3D") << QStringList{};
        QTest::addRow("unsmoothed") << QStringList{"--mode", "2d", "--mono"};
        QTest::addRow("bodies") << QStringList{"--mode", "2d", "--components"};
        QTest::addRow("back end") << QStringList{"--mode", "2d", "--backend", "pull"};
    }

    void whatTakesADeviceSaysThatThereIsNone() {
        QFETCH(QStringList, options);
        const Outcome run = copperscope(wordsFor(options), m_folder.path(), withoutDriver());
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.err.contains("Vulkan"), run.err.constData());
    }

private:
    static QProcessEnvironment withoutDriver() {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("VK_DRIVER_FILES", "/nowhere/driver.json");
        environment.insert("VK_ICD_FILENAMES", "/nowhere/driver.json");
        return environment;
    }
    static QStringList wordsFor(const QStringList& options) {
        return QStringList{"render", "-o", "out.png", "--size", QString("%1x%2").arg(kWidth).arg(kHeight)} + options;
    }
    std::vector<png_byte> draw(const QStringList& options, const QProcessEnvironment& environment) {
        QFile::remove(m_folder.filePath("out.png"));
        const Outcome run = copperscope(wordsFor(options), m_folder.path(), environment);
        return run.exitCode == 0 ? readPng(m_folder.filePath("out.png")) : std::vector<png_byte>();
    }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(FlatRenderTest)
#include "flat_render_test.moc"
