#include "model/design_rules/track_checks.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

    /// An axis-parallel square is as wide as its side along an axis, and as its diagonal at 45 degrees.
    void tracksOfSquarePensHaveAWidth() {
        for (const auto& [end, width] : {std::pair(model::Point{kMm, 0}, 50e3),
                                         {{0, kMm}, 50e3},
                                         {{kMm, -kMm}, 50e3 * std::numbers::sqrt2},
                                         {{3 * kMm, 4 * kMm}, 70e3}}) {
            Board board;
            board.builder.beginLayer(board.top);
            board.builder.addLine({{0, 0}, end, 50 * kUm, 0}, of(board.a, model::kSquarePen));
            const auto document = board.builder.finish();
            QVERIFY(check(*document, RuleKind::TrackWidth, 50 * kUm).isPassed());
            const RuleReport report = check(*document, RuleKind::TrackWidth, 100 * kUm);
            QCOMPARE(report.findings.size(), std::size_t{1});
            const model::Spacing& across = report.findings.front().spacing;
            QVERIFY(std::abs(across.distance - width) < 0.001);
            QVERIFY(std::abs(std::hypot(across.to.x - across.from.x, across.to.y - across.from.y) - width) < 0.001);
        }
    }

    void anglesOfSquarePensAreNotLookedAt() {
        Board board;
        board.builder.beginLayer(board.top);
        board.builder.addLine({{0, 0}, {kMm, 0}, 50 * kUm, 0}, of(board.a, model::kSquarePen));
        board.builder.addLine({{0, 0}, {kMm, kMm / 2}, 50 * kUm, 0}, of(board.a, model::kSquarePen));
        const RuleReport report = check(*board.builder.finish(), RuleKind::AcuteAngle, 0);
        QVERIFY(report.isPassed() && !report.isComplete());
        QCOMPARE(model::textOf(report.unchecked.at(0)),
                 std::string("2 tracks: drawn with a square pen on layer top, whose angles are not looked at"));
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
