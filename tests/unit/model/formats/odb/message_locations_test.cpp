#include "model/formats/odb/message_locations.h"

#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;
using model::Diagnostic;
using model::ElementId;
using model::Point;

namespace {

constexpr model::Nm kMm = 1'000'000;

}  // namespace

class MessageLocationsTest : public QObject {
    Q_OBJECT

private slots:
    void aRepairedRecordPointsToItsElement() {
        Folder folder;
        // An arc around one of its ends is taken for a straight line.
        writeSmallJob(folder, "UNITS=MM\n$0 r100\nP 5 5 0 P 0 0\nA 1 1 3 1 1 1 0 P 0 Y\nP 9 9 0 P 0 0\n");
        const auto d = read(folder.path());
        const Diagnostic* entry = findDiagnostic(d->diagnostics, "without a radius");
        QVERIFY(entry != nullptr);
        QCOMPARE(entry->line, 4U);
        QCOMPARE(entry->element, elementOf(*d, "TOP", 1));
        QVERIFY(entry->element.isValid() && !entry->location);
    }

    void aLineInsideOfASurfacePointsToTheSurface() {
        Folder folder;
        writeSmallJob(folder,
                      "UNITS=MM\n$0 r100\nP 5 5 0 P 0 0\nS P 0\nOB 1 1 I\nOS 2 1\nOS 2 2\nOS 1 1\nOE\nXX\nSE\n");
        const auto d = read(folder.path());
        bool isFound = false;
        for (const Diagnostic& entry : d->diagnostics.entries()) {
            if (entry.line >= 4 && entry.line <= 11 && entry.element.isValid()) {
                QCOMPARE(entry.element, elementOf(*d, "TOP", 1));
                isFound = true;
            }
        }
        QVERIFY(isFound);
    }

    void aStrokeInsideOfATrailPointsToTheTrail() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r100\nL 0 0 5 0 0 P 0\nA 5 0 9 0 9 0 0 P 0 Y\nL 9 0 9 9 0 P 0\n");
        const auto d = read(folder.path());
        const Diagnostic* entry = findDiagnostic(d->diagnostics, "without a radius");
        QVERIFY(entry != nullptr);
        QCOMPARE(entry->line, 4U);
        QCOMPARE(d->elements.kind[entry->element.row()], model::ElementKind::Trail);
        QCOMPARE(entry->element, elementOf(*d, "TOP", 0));
    }

    void aRecordThatDrawsNothingPointsToItsPlace() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r100\n$1 nowhere\nP 5 5 0 P 0 0\nP 7 8 1 P 0 0\n");
        const auto d = read(folder.path());
        const Diagnostic* entry = findDiagnostic(d->diagnostics, "symbol nowhere");
        QVERIFY(entry != nullptr);
        QVERIFY(!entry->element.isValid());
        QCOMPARE(entry->location, std::optional(Point{7 * kMm, 8 * kMm}));
        QCOMPARE(entry->text[0], 'S');
    }

    void whatIsNoRecordHasNoPlace() {
        Folder folder;
        writeSmallJob(folder, "UNITS=MM\n$0 r100\nP 5 5 0 P 0 0\nP 5 x 0 P 0 0\nnonsense\n");
        const auto d = read(folder.path());
        for (const std::uint32_t line : {4U, 5U}) {
            const auto& entries = d->diagnostics.entries();
            const auto entry = std::ranges::find(entries, line, &Diagnostic::line);
            QVERIFY(entry != entries.end());
            QVERIFY(!entry->element.isValid() && !entry->location);
        }
    }

    void messagesOfACopyPointToTheFirstCopyOnTheBoard() {
        Folder folder;
        folder.copyJob("panel");
        folder.write("steps/card/layers/top/features", "UNITS=MM\n$0 r100\nA 1 1 3 1 1 1 0 P 0 Y\n");
        const auto d = read(folder.path(), "panel");
        const Diagnostic* entry = findDiagnostic(d->diagnostics, "without a radius");
        QVERIFY(entry != nullptr);
        QVERIFY(!entry->element.isValid());
        QVERIFY(entry->location.has_value());
        const model::StepInstance& first = d->instances.front();
        const model::Document& card = *d->steps[first.step];
        const model::Box box = card.boxOf(ElementId{std::size_t{0}});
        const Point middle{static_cast<model::Nm>((box.min.x + box.max.x) / 2),
                           static_cast<model::Nm>((box.min.y + box.max.y) / 2)};
        QCOMPARE(*entry->location, first.placement.apply(middle));
    }
};

QTEST_APPLESS_MAIN(MessageLocationsTest)
#include "message_locations_test.moc"
