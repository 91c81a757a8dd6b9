// Copper layers as `render --mono` draws them, of every form a board is there in, against rasters that KiCad drew
// itself of the board's source, through none of these forms.
#include <png.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

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

// ---- boards and their forms ----

/// The forms of a board: what its file is called after the board's name, in formats/kicad, packed or not.
constexpr const char* kForms[] = {".kicad_pcb", "-ipc2581b.xml", "-ipc2581c.xml", "-gerbers.zip"};
constexpr const char* kOdb = ".tgz";  ///< in kicad/, of every board that has rasters

/// Empty if the board is not there in this form.
fs::path fileOf(const std::string& board, const std::string& form) {
    if (form == kOdb) {
        return locations::boards() / "kicad" / (board + form);
    }
    const fs::path plain = locations::boards() / "formats" / "kicad" / board / (board + form);
    const fs::path packed = plain.string() + ".gz";
    return fs::exists(plain) ? plain : fs::exists(packed) ? packed : fs::path();
}

/// How many mm² of copper a form has elsewhere than KiCad, on each layer: oracle_test knows why.
double misplacedCopper(const QString& board, const QString& form) {
    return board == "RoyalBlue54L-Feather" && form.startsWith("-ipc2581") ? 23.0 : 0.0;
}

/// The part of the board that a raster shows, in the program's words.
struct Window {
    double scale = 0.0;  ///< pixels per mm
    double left = 0.0;   ///< mm
    double top = 0.0;

    [[nodiscard]] QString words(const Picture& picture) const {
        return QString("%1,%2,%3,%4")
            .arg(left, 0, 'f', 6)
            .arg(top - picture.height / scale, 0, 'f', 6)
            .arg(left + picture.width / scale, 0, 'f', 6)
            .arg(top, 0, 'f', 6);
    }
};

Window windowOf(const fs::path& json) {
    QFile file(QString::fromStdString(json.string()));
    const QJsonObject location =
        file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
    return {location["px_per_mm"].toDouble(), location["odb_x_left_mm"].toDouble(),
            location["odb_y_top_mm"].toDouble()};
}

}  // namespace

class KicadRasterTest : public QObject {
    Q_OBJECT

private slots:
    void copperIsWhereKicadHasIt_data() {
        QTest::addColumn<QString>("board");
        QTest::addColumn<QString>("form");
        QTest::addColumn<QString>("layer");
        for (const auto& board : fs::directory_iterator(locations::boards() / "kicad" / "ref")) {
            const std::string name = board.path().filename().string();
            addLayers(name, kOdb);
            for (const char* form : kForms) {
                if (!fileOf(name, form).empty()) {
                    addLayers(name, form);
                }
            }
        }
    }
    void copperIsWhereKicadHasIt() {
        QFETCH(QString, board);
        QFETCH(QString, form);
        QFETCH(QString, layer);
        const fs::path folder = locations::boards() / "kicad" / "ref" / board.toStdString();
        Picture reference = readPng((folder / (layer.toStdString() + ".png")).string());
        const Window window = windowOf(folder / "ref.json");
        QVERIFY(reference.width > 0 && window.scale > 0.0);
        makeCopperWhite(reference);
        const QTemporaryDir drawn;
        const QString out = drawn.filePath("out.png");
        QProcess process;
        process.start(
            locations::kProgram,
            {"render", QString::fromStdString(fileOf(board.toStdString(), form.toStdString()).string()), "-o", out,
             "--mono", "--layers", layer, "--size", QString("%1x%2").arg(reference.width).arg(reference.height),
             "--window", window.words(reference)});
        QVERIFY(process.waitForFinished(300'000));
        QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
        const Picture ours = readPng(out.toStdString());
        QCOMPARE(ours.width, reference.width);
        QCOMPARE(ours.height, reference.height);
        const Count count = compare(ours, reference);
        qInfo("%zu of %zu copper pixels differ", count.different, count.copper);
        QVERIFY(count.copper > 0);
        const double expected = misplacedCopper(board, form) * window.scale * window.scale;
        const double allowed = 0.001 * static_cast<double>(count.copper);
        QVERIFY(std::abs(static_cast<double>(count.different) - expected) <= allowed);
    }

private:
    static void addLayers(const std::string& board, const char* form) {
        for (const auto& entry : fs::directory_iterator(locations::boards() / "kicad" / "ref" / board)) {
            // Loading the largest board takes longest by far: one layer of it must do.
            const std::string layer = entry.path().stem().string();
            const bool isMuch = !locations::isThorough() && board.starts_with("jetson") && layer != "f.cu";
            if (entry.path().extension() == ".png" && !isMuch) {
                QTest::addRow("%s%s %s", board.c_str(), form, layer.c_str())
                    << QString::fromStdString(board) << QString(form) << QString::fromStdString(layer);
            }
        }
    }
};

QTEST_APPLESS_MAIN(KicadRasterTest)
#include "kicad_raster_test.moc"
