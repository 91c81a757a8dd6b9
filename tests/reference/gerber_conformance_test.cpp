// Files of the Gerber language, one per feature, against pictures that another program drew of them
// (tests/data/gerber-conformance), sample by sample. Where the two differ, the Gerber Layer Format Specification
// decides: gerber_expected.cpp lists what gerbv draws otherwise, with the paragraph, and paints what has to be there.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "model/formats/registry.h"
#include "model/text/whole_file.h"
#include "tests/locations.h"
#include "tests/reference/document_painter.h"
#include "tests/reference/gerber_expected.h"
#include "tests/reference/svg_painter.h"

using namespace reference;

namespace {

namespace fs = std::filesystem;

constexpr double kPitch = 0.02;  // mm
/// What is narrower than 2 kAround + 1 samples, 60 µm, is the pictures': their numbers are rounded.
constexpr std::size_t kAround = 1;
/// mm: what lies farther apart is no picture of a board.
constexpr double kMostSize = 1'000;
/// mm²: a difference of one square of 0.1 mm has 0.0036.
constexpr double kMostDifference = 0.002;

fs::path folder() {
    return fs::path(locations::kTestData) / "gerber-conformance";
}

std::shared_ptr<const model::Document> read(const fs::path& path) {
    base::Progress progress;
    const auto board = model::readBoard(path, {}, progress);
    return board ? *board : nullptr;
}

/// What the file draws: the elements of its only layer.
std::vector<model::ElementId> elementsOf(const model::Document& board) {
    std::vector<model::ElementId> elements;
    for (const model::Layer& layer : board.layers) {
        for (std::uint32_t i = 0; i < layer.elements.count && !layer.isSynthetic; ++i) {
            elements.push_back(model::ElementId{layer.elements.first + i});
        }
    }
    return elements;
}

model::Box boxOf(const model::Document& board) {
    model::Box box;
    for (const model::ElementId element : elementsOf(board)) {
        box.include(board.boxOf(element));
    }
    return box;
}

/// Holes as they are drilled: the document keeps their barrels.
void paintAll(const model::Document& board, Raster& raster) {
    for (const model::ElementId element : elementsOf(board)) {
        const bool isHole = (board.elements.flags[element.row()] & model::kHole) != 0;
        if (isHole && board.elements.kind[element.row()] == model::ElementKind::Circle) {
            const model::CircleGeometry& hole = board.circles[board.elements.geometry[element.row()]];
            raster.fill({circle({hole.centre.x * 1e-6, hole.centre.y * 1e-6}, hole.diameter * 0.5e-6)}, true);
        } else {
            paint(board, element, raster);
        }
    }
}

Raster rasterFor(const model::Box& box) {
    return {{box.min.x * 1e-6 - 1, box.min.y * 1e-6 - 1}, {box.max.x * 1e-6 + 1, box.max.y * 1e-6 + 1}, kPitch};
}

/// In mm². The picture is laid on what Copperscope draws by their upper left corners: it has an origin of its own.
double differenceFrom(const SvgPicture& picture, const model::Document& board) {
    const model::Box box = boxOf(board);
    const auto [low, high] = picture.corners();
    if (high.x - low.x > kMostSize || high.y - low.y > kMostSize) {
        return kMostSize * kMostSize;
    }
    const Point shift{box.min.x * 1e-6 - low.x, box.max.y * 1e-6 - high.y};
    model::Box both = box;  // with what only the picture draws
    both.include(model::Point{static_cast<model::Nm>((high.x + shift.x) * 1e6), box.min.y});
    both.include(model::Point{box.min.x, static_cast<model::Nm>((low.y + shift.y) * 1e6)});
    Raster ours = rasterFor(both);
    Raster drawn = ours;
    paintAll(board, ours);
    picture.paint(drawn, shift);
    return ours.differenceWider(drawn, kAround);
}

}  // namespace

class GerberConformanceTest : public QObject {
    Q_OBJECT

private slots:
    void filesDrawWhatTheirPicturesShow_data() {
        QTest::addColumn<QString>("name");
        for (const auto& entry : fs::recursive_directory_iterator(folder())) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".gbr" || ending == ".drl") {
                const std::string name = fs::relative(entry.path(), folder()).generic_string();
                QTest::newRow(name.c_str()) << QString::fromStdString(name);
            }
        }
    }
    void filesDrawWhatTheirPicturesShow() {
        QFETCH(QString, name);
        const auto board = read(folder() / name.toStdString());
        QVERIFY(board != nullptr);
        QString svg = name;
        svg.replace('/', '_').chop(4);
        const auto text = model::readWholeFile(folder() / "reference-svg" / (svg + ".svg").toStdString());
        QVERIFY(text.ok());
        const SvgPicture picture(*text);
        QVERIFY2(picture.unknown().empty(), picture.unknown().empty() ? "" : picture.unknown()[0].c_str());
        const double difference = differenceFrom(picture, *board);
        const ExpectedPicture* const expected = expectedPicture(name.toStdString());
        if (expected == nullptr) {
            QVERIFY2(difference < kMostDifference, QByteArray::number(difference));
            return;
        }
        QVERIFY2(difference > kMostDifference, "the picture is right: it needs no entry in gerber_expected.cpp");
        Raster ours = rasterFor(boxOf(*board));
        Raster right = ours;
        paintAll(*board, ours);
        expected->paint(right);
        if (expected->paintOpen) {
            expected->paintOpen(ours);
            expected->paintOpen(right);
        }
        QVERIFY2(ours.differenceWider(right, kAround) < kMostDifference,
                 QByteArray::number(ours.differenceWider(right, kAround)));
        QVERIFY2(std::abs(ours.area() - right.area()) < 0.002 * right.area(), QByteArray::number(ours.area()));
    }
};

QTEST_APPLESS_MAIN(GerberConformanceTest)
#include "gerber_conformance_test.moc"
