// Counterbores and countersinks of KiCad 10, and what becomes of them on the board.
#include "model/formats/kicad/post_machining.h"

#include <QtTest>
#include <map>
#include <set>

#include "model/board/holes.h"
#include "model/formats/drawing/assembly.h"
#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;

namespace {

const DrawnJob& board() {
    static const DrawnJob job = drawn(fileText("machining.kicad_pcb"));
    return job;
}

/// Widths in µm of what is drilled wider at a place, by layer.
std::map<std::string, Nm> widthsAt(Point at) {
    std::map<std::string, Nm> widths;
    for (std::size_t row = 0; row < board().layers.size(); ++row) {
        for (const DrawnFeature& feature : board().steps[0].features[row]) {
            if (board().layers[row].use == LayerUse::DualDiameter && feature.a == at) {
                widths[board().layers[row].name] = shapeOf(board(), feature).width / 1000;
            }
        }
    }
    return widths;
}

using Widths = std::map<std::string, Nm>;

}  // namespace

class PostMachiningTest : public QObject {
    Q_OBJECT

private slots:
    void counterboresReachAllCopperOfTheirDepth() {
        const Widths expected = {{"wide_drill_F.Cu-F.Cu", 1200}, {"wide_drill_F.Cu-In1.Cu", 1200}};
        QCOMPARE(widthsAt({10 * kMm, -10 * kMm}), expected);
    }

    /// At 45° the cone is narrower by twice the depth.
    void countersinksGetNarrower() {
        const Widths whole = {{"wide_drill_B.Cu-B.Cu", 2000}, {"wide_drill_In2.Cu-B.Cu", 2000 - 2 * 235}};
        QCOMPARE(widthsAt({20 * kMm, -10 * kMm}), whole);
        const Widths shallow = {{"wide_drill_F.Cu-F.Cu", 2000}};
        QCOMPARE(widthsAt({30 * kMm, -10 * kMm}), shallow);
        // From 1.4 to 1 mm in 0.4 mm.
        const Widths steep = {{"wide_drill_B.Cu-B.Cu", 1400}, {"wide_drill_In2.Cu-B.Cu", 1400 - 235}};
        QCOMPARE(widthsAt({20 * kMm, -30 * kMm}), steep);
    }

    void whatIsNotSaidIsReported() {
        const Diagnostics& found = board().diagnostics;
        QCOMPARE(messages(found, "no wider than its hole"), 1U);
        QCOMPARE(messages(found, "in an unknown way"), 1U);
        QCOMPARE(messages(found, "counterbore has no depth"), 1U);
        QCOMPARE(messages(found, "countersink has no angle"), 1U);
        QCOMPARE(messages(found, "of slots are not shown"), 1U);
        QCOMPARE(messages(found, "shown as far as the copper"), 6U);
        const Widths outer = {{"wide_drill_F.Cu-F.Cu", 6000}};
        QCOMPARE(widthsAt({10 * kMm, -30 * kMm}), outer);
    }

    /// The plating ends where the tool has been, and the wide part does not pass the board.
    void platingIsTakenWithTheCopper() {
        base::Progress progress;
        const auto document = formats::assemble(drawn(fileText("machining.kicad_pcb")), 0.0, progress);
        QVERIFY(document.ok());
        const Document& assembled = **document;
        const LayerId wide = assembled.findLayer("wide_drill_F.Cu-F.Cu");
        QVERIFY(wide.isValid());
        QCOMPARE(spanOf(assembled, ElementId{std::size_t{assembled.layer(wide).elements.first}}), HoleSpan::Blind);
        std::set<std::string> tops;
        for (const PlatedSpan& span : assembled.platedSpans) {
            tops.insert(assembled.layer(span.top).name);
        }
        QVERIFY(tops.contains("In2.Cu"));
    }
};

QTEST_APPLESS_MAIN(PostMachiningTest)
#include "post_machining_test.moc"
