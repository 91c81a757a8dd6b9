// What reading costs in memory: records are parsed without an allocation each, and a document stays small.
#include "model/formats/odb/features/features.h"
#include "tests/counted_memory.h"
#include "tests/locations.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;

namespace {

/// Strokes, pads and small surfaces with attributes and IDs, as a busy layer has them.
std::string bigLayer(std::size_t bytes) {
    std::string text = "UNITS=MM\n@0 .pad_usage\n@1 .net_name\n&0 GND\n$0 r100.0\n$1 rect500.0x250.0\n";
    text.reserve(bytes + 256);
    for (int i = 0; text.size() < bytes; ++i) {
        const std::string x = std::to_string(i % 997) + ".125000";
        const std::string y = std::to_string(i % 89) + ".062500";
        const std::string tail = ";" + std::to_string(i % 2) + "=0;ID=" + std::to_string(i) + "\n";
        text += "L " + x + " " + y + " " + y + " " + x + " 0 P 0" + tail;
        text += "P " + x + " " + y + " 1 P 0 8 " + std::to_string(i % 360) + tail;
        text += "S P 0" + tail + "OB " + x + " " + y + " I\nOS 1 0\nOS 1 1\nOS " + x + " " + y + "\nOE\nSE\n";
    }
    return text;
}

template <class T>
std::size_t bytesOf(const base::Table<T>& column) {
    return static_cast<const std::vector<T>&>(column).capacity() * sizeof(T);
}

}  // namespace

class ParseMemoryTest : public QObject {
    Q_OBJECT

private slots:
    /// 30 MB: the features, and nothing else that grows with the text beyond their tables.
    void aLargeFileNeedsASmallMultipleOfItself() {
        const std::string text = bigLayer(30'000'000);
        model::Diagnostics diagnostics;
        counted::resetPeak();
        const counted::Memory before = counted::memory();
        const model::odb::FeatureFile file =
            model::odb::parseFeatures(text, "features", model::odb::Unit::Millimetre, diagnostics);
        QVERIFY(diagnostics.entries().empty());
        QVERIFY(file.features.size() > 400'000);
        QCOMPARE(file.attributes.sets.size(), std::size_t{2});
        // Tables that double: some twenty steps each.
        const std::size_t allocations = counted::memory().allocations - before.allocations;
        QVERIFY2(allocations < 500, qPrintable(QString::number(allocations)));
        const std::size_t bytes = counted::memory().peak - before.live;
        QVERIFY2(bytes < 3 * text.size(), qPrintable(QString::number(bytes / 1'000'000)));
    }

    /// Of all columns of a document: at most 96 bytes per element, besides the points of contours and trails.
    void aDocumentNeedsFewBytesPerElement() {
        const auto d = read(locations::kSample);
        const model::ElementTable& e = d->elements;
        const std::size_t bytes = bytesOf(e.kind) + bytesOf(e.flags) + bytesOf(e.layer) + bytesOf(e.net) +
                                  bytesOf(e.symbol) + bytesOf(e.geometry) + bytesOf(e.firstFeature) + bytesOf(e.line) +
                                  bytesOf(e.attributes) + bytesOf(d->lines) + bytesOf(d->arcs) + bytesOf(d->circles) +
                                  bytesOf(d->trails) + bytesOf(d->areas) + bytesOf(d->shapes.shapes) +
                                  bytesOf(d->netElements) + bytesOf(d->netStart) + bytesOf(d->painted.areas) +
                                  bytesOf(d->painted.features);
        QVERIFY(e.size() > 1000);
        QVERIFY2(bytes <= 96 * e.size(),
                 qPrintable(QString::number(static_cast<double>(bytes) / static_cast<double>(e.size()))));
        const std::size_t points = d->shapes.nodes.size() + d->trailNodes.size();
        const std::size_t pointBytes =
            bytesOf(d->shapes.nodes) + bytesOf(d->shapes.contours) + bytesOf(d->trailNodes) + bytesOf(d->trailWidths);
        QVERIFY(pointBytes <= 32 * points);
    }
};

QTEST_APPLESS_MAIN(ParseMemoryTest)
#include "parse_memory_test.moc"
