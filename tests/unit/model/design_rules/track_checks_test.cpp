#include "model/design_rules/track_checks.h"

#include <QtTest>
#include <algorithm>
#include <array>

#include "tests/unit/model/design_rules/rule_board.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using namespace rule_board;
using model::DocumentBuilder;
using model::ElementId;
using model::NetId;
using model::Nm;
using model::RuleKind;
using model::RuleReport;

class TrackChecksTest : public QObject {
    Q_OBJECT

private slots:
    /// Strokes of texts, whatever net they were inferred to be, and shapes of no net: a note.
    void strokesOfTextsAreNoTracks() {
        Board board;
        board.builder.beginLayer(board.top);
        const auto stroke = [&](Nm y, NetId net) {
            return board.builder.addLine({{0, y}, {kMm, y}, 60 * kUm, 0}, of(net));
        };
        stroke(0, board.a);
        stroke(kMm, {});
        const ElementId text = stroke(2 * kMm, board.b);
        model::ElementGroup group;
        group.type = board.builder.string("TEXT");
        board.builder.addGroup(group, std::array{text});
        const RuleReport report = check(*board.builder.finish(), RuleKind::TrackWidth, 100 * kUm);
        QCOMPARE(report.findings.size(), std::size_t{1});
        QCOMPARE(report.findings.front().a, ElementId{0U});
        QCOMPARE(std::ranges::count(report.notes,
                                    "2 lines of texts or of no net on layer top are narrower than "
                                    "tracks may be, and no tracks"),
                 1);
    }

    /// Without nets nobody knows which strokes are tracks.
    void withoutNetsAllStrokesAreTracks() {
        DocumentBuilder builder;
        builder.beginLayer(addLayer(builder, "top"));
        builder.addLine({{0, 0}, {kMm, 0}, 60 * kUm, 0}, {});
        QVERIFY(!check(*builder.finish(), RuleKind::TrackWidth, 100 * kUm).isPassed());
    }
};

QTEST_GUILESS_MAIN(TrackChecksTest)
#include "track_checks_test.moc"
