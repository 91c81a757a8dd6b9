// How footprints lie on the board.
#include "model/formats/kicad/footprints.h"

#include <QtTest>
#include <algorithm>
#include <cstdlib>

#include "tests/unit/model/formats/kicad/kicad_testing.h"

using namespace kicad_testing;

namespace {

constexpr std::string_view kMessage = "ootprints on the back are stored as seen through the board";

/// One with two pads, turned by 45 degrees.
std::string footprint(const std::string& layer, const std::string& refdes) {
    const std::string pads = "(size 1 1) (layers \"" + layer + "\") (net 1))";
    return "(footprint \"T:x\" (layer \"" + layer + "\") (at 10 10 45) (property \"Reference\" \"" + refdes +
           "\") (pad \"1\" smd rect (at 1 0.5 45) " + pads + " (pad \"2\" smd rect (at -1 0.5 45) " + pads + ")\n";
}

}  // namespace

class KicadFootprintsTest : public QObject {
    Q_OBJECT

private slots:
    /// On the back 180 degrees more than the file says, clockwise as seen from below.
    void rotationsAreClockwiseAsSeenFromTheSideOfThePart() {
        const DrawnJob job = boardWith(footprint("F.Cu", "R1") + footprint("B.Cu", "R2"));
        const auto& parts = job.steps[0].components;
        QCOMPARE(parts.size(), std::size_t{2});
        QCOMPARE(parts[0].clockwiseDeg, 315.0);
        QCOMPARE(parts[0].isMirrored, std::optional(false));
        QCOMPARE(parts[1].clockwiseDeg, 225.0);
        QCOMPARE(parts[1].isMirrored, std::optional(true));
        for (const formats::DrawnComponent& part : parts) {
            const auto& package = job.steps[0].packages[static_cast<std::size_t>(part.package)];
            const Placement placement{part.position, part.clockwiseDeg, *part.isMirrored};
            QCOMPARE(part.pins.size(), std::size_t{2});
            for (const formats::DrawnPin& pin : part.pins) {
                const Point at = placement.apply(package.pins[static_cast<std::size_t>(pin.packagePin)].position);
                QVERIFY(std::abs(at.x - pin.position.x) <= 1 && std::abs(at.y - pin.position.y) <= 1);
            }
        }
    }

    /// As in ODB++ that KiCad writes, where a part has its value for a name and in an attribute.
    void theValueIsThePartAndAnAttribute_data() {
        QTest::addColumn<QByteArray>("field");
        QTest::addColumn<QByteArray>("version");
        QTest::newRow("property") << QByteArray("(property \"Value\" \"10uF\" (at 0 0) (layer \"F.Fab\"))")
                                  << QByteArray("20241229");
        QTest::newRow("text") << QByteArray("(fp_text value \"10uF\" (at 0 0) (layer \"F.Fab\"))")
                              << QByteArray("20211014");
    }
    void theValueIsThePartAndAnAttribute() {
        QFETCH(QByteArray, field);
        QFETCH(QByteArray, version);
        const DrawnJob job = boardWith(
            "(footprint \"x\" (layer \"F.Cu\") (at 0 0) (attr smd exclude_from_bom) " + field.toStdString() + ")", "",
            version.toStdString());
        const formats::DrawnComponent& part = job.steps[0].components[0];
        QCOMPARE(part.part, std::string("10uF"));
        QCOMPARE(part.properties, (formats::Words{{"Value", "10uF"}, {"exclude_from_bom", "yes"}}));
    }

    void flippedPackagesAreReportedOncePerBoard() {
        const DrawnJob job = boardWith(footprint("F.Cu", "R1") + footprint("B.Cu", "R2") + footprint("B.Cu", "R3"));
        QCOMPARE(messages(job.diagnostics, kMessage), 1U);
        const auto& entries = job.diagnostics.entries();
        const auto found = std::ranges::find_if(
            entries, [](const Diagnostic& entry) { return entry.text.find(kMessage) != std::string::npos; });
        QCOMPARE(found->severity, Severity::Info);
        QCOMPARE(found->file, std::string("board.kicad_pcb"));
        QCOMPARE(found->line, 3U);
    }

    void boardsWithoutPartsOnTheBackHaveNoSuchMessage() {
        const DrawnJob job = boardWith(footprint("F.Cu", "R1"));
        QCOMPARE(messages(job.diagnostics, kMessage), 0U);
    }
};

QTEST_APPLESS_MAIN(KicadFootprintsTest)
#include "footprints_test.moc"
