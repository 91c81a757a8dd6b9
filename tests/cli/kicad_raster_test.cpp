// Copper layers as `render --mono` draws them against rasters that KiCad drew itself, not through ODB++.
#include <png.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <filesystem>

#include "tests/locations.h"

namespace {

namespace fs = std::filesystem;

struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<png_byte> grey;

    [[nodiscard]] bool isWhite(std::int64_t x, std::int64_t y) const {
        const bool isInside = x >= 0 && y >= 0 && x < width && y < height;
        return isInside && grey[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] >= 128;
    }
};

Picture readPng(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Picture picture;
    if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
        return picture;
    }
    image.format = PNG_FORMAT_GRAY;
    picture.grey.resize(PNG_IMAGE_SIZE(image));
    const png_color black{0, 0, 0};
    if (png_image_finish_read(&image, &black, picture.grey.data(), 0, nullptr) != 0) {
        picture.width = image.width;
        picture.height = image.height;
    }
    return picture;
}

/// The reference is black on white or white on black: its corner is no copper.
void makeCopperWhite(Picture& picture) {
    if (picture.isWhite(0, 0)) {
        for (png_byte& value : picture.grey) {
            value = static_cast<png_byte>(255 - value);
        }
    }
}

bool isUniform(const Picture& picture, std::int64_t x, std::int64_t y) {
    const bool white = picture.isWhite(x, y);
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
            if (picture.isWhite(x + dx, y + dy) != white) {
                return false;
            }
        }
    }
    return true;
}

struct Count {
    std::size_t copper = 0;
    std::size_t different = 0;  ///< beyond the outermost pixel along edges
};

Count compare(const Picture& ours, const Picture& reference) {
    Count count;
    for (std::int64_t y = 0; y < reference.height; ++y) {
        for (std::int64_t x = 0; x < reference.width; ++x) {
            count.copper += reference.isWhite(x, y) ? 1 : 0;
            const bool differs = ours.isWhite(x, y) != reference.isWhite(x, y);
            count.different += differs && isUniform(reference, x, y) ? 1 : 0;
        }
    }
    return count;
}

}  // namespace

class KicadRasterTest : public QObject {
    Q_OBJECT

private slots:
    void copperIsWhereKicadHasIt_data() {
        QTest::addColumn<QString>("board");
        QTest::addColumn<QString>("layer");
        for (const auto& board : fs::directory_iterator(locations::boards() / "kicad" / "ref")) {
            for (const auto& entry : fs::directory_iterator(board)) {
                const std::string name = board.path().filename().string();
                // Loading the largest board takes longest by far: one layer of it must do.
                const bool isMuch =
                    !locations::isThorough() && name.starts_with("jetson") && entry.path().stem() != "f.cu";
                if (entry.path().extension() == ".png" && !isMuch) {
                    QTest::addRow("%s %s", name.c_str(), entry.path().stem().c_str())
                        << QString::fromStdString(name) << QString::fromStdString(entry.path().stem().string());
                }
            }
        }
    }
    void copperIsWhereKicadHasIt() {
        QFETCH(QString, board);
        QFETCH(QString, layer);
        const QString boards = QString::fromStdString((locations::boards() / "kicad/").string());
        Picture reference = readPng((boards + "ref/" + board + "/" + layer + ".png").toStdString());
        QVERIFY(reference.width > 0);
        makeCopperWhite(reference);
        QFile file(boards + "ref/" + board + "/ref.json");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject location = QJsonDocument::fromJson(file.readAll()).object();
        const double scale = location["px_per_mm"].toDouble();
        const double left = location["odb_x_left_mm"].toDouble();
        const double top = location["odb_y_top_mm"].toDouble();
        const QTemporaryDir folder;
        const QString out = folder.filePath("out.png");
        QProcess process;
        process.start(locations::kProgram,
                      {"render", boards + board + ".tgz", "-o", out, "--mono", "--layers", layer, "--size",
                       QString("%1x%2").arg(reference.width).arg(reference.height), "--window",
                       QString("%1,%2,%3,%4")
                           .arg(left, 0, 'f', 6)
                           .arg(top - reference.height / scale, 0, 'f', 6)
                           .arg(left + reference.width / scale, 0, 'f', 6)
                           .arg(top, 0, 'f', 6)});
        QVERIFY(process.waitForFinished(300'000));
        QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
        const Picture ours = readPng(out.toStdString());
        QCOMPARE(ours.width, reference.width);
        QCOMPARE(ours.height, reference.height);
        const Count count = compare(ours, reference);
        qInfo("%zu of %zu copper pixels differ", count.different, count.copper);
        QVERIFY(count.copper > 0);
        QVERIFY(static_cast<double>(count.different) <= 0.001 * static_cast<double>(count.copper));
    }
};

QTEST_APPLESS_MAIN(KicadRasterTest)
#include "kicad_raster_test.moc"
