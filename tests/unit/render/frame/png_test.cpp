#include "render/frame/png.h"

#include <png.h>

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "render/scene/view_settings.h"
#include "tests/full_disk.h"

using namespace render;

class PngTest : public QObject {
    Q_OBJECT

    static Image gradient() {
        Image image{31, 17, {}};
        for (std::uint32_t i = 0; i < 31 * 17; ++i) {
            const auto value = static_cast<std::uint8_t>(i % 256);
            image.rgba.insert(image.rgba.end(), {value, static_cast<std::uint8_t>(255 - value), 128, 255});
        }
        return image;
    }

    /// Does not compress: more than any buffer on the way.
    static Image noise() {
        Image image{300, 300, {}};
        std::uint32_t state = 1;
        for (std::size_t i = 0; i < 300 * 300 * 4; ++i) {
            state = state * 1664525U + 1013904223U;
            image.rgba.push_back(static_cast<std::uint8_t>(state >> 24U));
        }
        return image;
    }

private slots:
    void whatIsWrittenIsReadBack() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("picture.png").toStdString();
        const Image image = gradient();
        QVERIFY(writePng(image, path));
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        QVERIFY(png_image_begin_read_from_file(&png, path.c_str()) != 0);
        png.format = PNG_FORMAT_RGBA;
        QCOMPARE(png.width, 31U);
        QCOMPARE(png.height, 17U);
        std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
        QVERIFY(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr) != 0);
        QVERIFY(bytes == image.rgba);
    }

    void missingFolderIsNamed() {
        const auto status = writePng(gradient(), "/nonexistent/folder/picture.png");
        QVERIFY(!status);
        QCOMPARE(status.error().code, base::ErrorCode::OutputFailed);
        QVERIFY(status.error().text.find("/nonexistent/folder/picture.png") != std::string::npos);
        QVERIFY(status.error().text.find("No such file or directory") != std::string::npos);
    }

    void fullDiskIsReported() {
        if (!QFile::exists("/dev/full")) {
            QSKIP("this system has no /dev/full");
        }
        const auto status = writePng(noise(), "/dev/full");
        QVERIFY(!status);
        QCOMPARE(status.error().code, base::ErrorCode::OutputFailed);
        QVERIFY2(status.error().text.find("No space left on device") != std::string::npos, status.error().text.c_str());
        QVERIFY(QFile::exists("/dev/full"));  // not ours to remove
    }

    void aPictureThatDoesNotFitLeavesNoFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("picture.png");
        const FullDisk disk(1000);
        const auto status = writePng(noise(), path.toStdString());
        QVERIFY(!status);
        QCOMPARE(status.error().code, base::ErrorCode::OutputFailed);
        QVERIFY(!QFile::exists(path));
    }
};

QTEST_APPLESS_MAIN(PngTest)
#include "png_test.moc"
