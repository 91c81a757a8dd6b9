// Rules of solder mask on boards made for them.
#include "model/design_rules/mask_checks.h"

#include <QtTest>

#include "tests/unit/model/design_rules/rule_board.h"

using namespace hand_made;
using namespace rule_board;
using model::Nm;
using model::RuleKind;
using model::RuleReport;
using model::RuleTable;

class MaskChecksTest : public QObject {
    Q_OBJECT

private slots:
    void openingsThatMeetLeaveNoSliver() {
        Board board;
        board.builder.beginLayer(board.mask);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of({}));
        board.builder.addCircle({{100 * kUm, 0}, 200 * kUm, 0}, of({}));
        board.builder.addCircle({{350 * kUm, 0}, 200 * kUm, 0}, of({}));
        verifyNarrowest(*board.builder.finish(), RuleKind::MaskSliver, 50 * kUm);
    }

    void openingsThatAbutButForRoundingLeaveNoSliver() {
        for (const auto& [gapNm, isSliver] : {std::pair(2, false), std::pair(500, false), std::pair(501, true)}) {
            Board board;
            board.builder.beginLayer(board.mask);
            const int side = 1'000'000;
            for (const int x : {0, side + gapNm}) {
                const auto square = hand_made::rectangle({x, 0}, {x + side, side});
                board.builder.addArea({board.builder.addShape(square), {}}, of({}));
            }
            const RuleTable table{{}, {{RuleKind::MaskSliver, 100 * kUm, {}}}};  // tolerance: half a micrometre
            base::Progress progress;
            QCOMPARE(model::checkRules(*board.builder.finish(), table, progress)->isPassed(), !isSliver);
        }
    }

    void aThirdOpeningTakesTheSliverAway() {
        Board board;
        board.builder.beginLayer(board.mask);
        board.builder.addCircle({{0, 0}, 200 * kUm, 0}, of({}));
        board.builder.addCircle({{250 * kUm, 0}, 200 * kUm, 0}, of({}));
        board.builder.addLine({{0, 0}, {250 * kUm, 0}, 20 * kUm, 0}, of({}));
        QVERIFY(check(*board.builder.finish(), RuleKind::MaskSliver, 1000 * kUm).isPassed());
    }

    /// Its only copper is at the bottom: what the mask of the other face leaves free are no pads.
    void openingsOnTheFaceWithoutCopperHaveNoPads() {
        for (const auto& [side, findings] :
             {std::pair(model::LayerSide::Bottom, 0), std::pair(model::LayerSide::Top, 1)}) {
            model::DocumentBuilder builder;
            const model::LayerId mask = addLayer(builder, "mask", model::LayerType::SolderMask);
            const model::LayerId copper = addLayer(builder, "copper", model::LayerType::Signal);
            builder.layer(mask).side = model::LayerSide::Top;
            builder.layer(copper).side = side;
            const model::NetId net = builder.addNet("A");
            builder.beginLayer(mask);
            builder.addCircle({{0, 0}, 600 * kUm, 0}, of({}));
            builder.beginLayer(copper);
            builder.addCircle({{0, 0}, 600 * kUm, 0}, of(net, model::kPad));
            const RuleReport report = check(*builder.finish(), RuleKind::MaskToCopper, 50 * kUm);
            QCOMPARE(report.findings.size(), static_cast<std::size_t>(findings));
        }
    }

    /// A track that may be as close as it is lies nearer to the opening than a plane of its net.
    void closerCopperThatPassesHidesNone() {
        Board board;
        board.builder.beginLayer(board.mask);
        board.builder.addCircle({{0, 0}, 400 * kUm, 0}, of({}));
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 300 * kUm, 0}, of(board.a, model::kPad));
        board.builder.addLine({{310 * kUm, -kMm}, {310 * kUm, kMm}, 100 * kUm, 0}, of(board.b));
        const auto plane = board.builder.addShape(rectangle({-kMm, -kMm}, {-290 * kUm, kMm}));
        board.builder.addArea({plane, {}}, of(board.b));
        model::Rule toPlanes{RuleKind::MaskToForeign, 100 * kUm, {}};
        toPlanes.objects[0] = model::CopperObject::Plane;
        const RuleReport report =
            check(*board.builder.finish(), RuleTable{{}, {{RuleKind::MaskToForeign, 50 * kUm, {}}, toPlanes}});
        QCOMPARE(report.findings.size(), std::size_t{1});
        QCOMPARE(report.findings.front().rule, std::size_t{1});
        QVERIFY(std::abs(report.findings.front().spacing.distance - 90e3) < 1.0);
    }

    /// The opening of an NPTH, beside a track.
    void openingsWithoutCopperKeepAwayFromAll() {
        Board board;
        board.builder.beginLayer(board.mask);
        board.builder.addCircle({{0, 0}, 4 * kMm, 0}, of({}));
        board.builder.beginLayer(board.top);
        board.builder.addLine({{2060 * kUm, -kMm}, {2060 * kUm, kMm}, 100 * kUm, 0}, of(board.b));
        board.builder.beginLayer(board.drill);
        board.builder.addCircle({{0, 0}, 3 * kMm, 0}, of({}, model::kHole));
        verifyNarrowest(*board.builder.finish(), RuleKind::MaskToForeign, 10 * kUm);
    }

    /// Of two strokes that make an opening one lies beside the pad.
    void openingsThatMeetAreForOneCopper() {
        Board board;
        board.builder.beginLayer(board.mask);
        board.builder.addLine({{-300 * kUm, 0}, {300 * kUm, 0}, 340 * kUm, 0}, of({}));
        board.builder.addLine({{-300 * kUm, 220 * kUm}, {300 * kUm, 220 * kUm}, 100 * kUm, 0}, of({}));
        board.builder.beginLayer(board.top);
        board.builder.addCircle({{0, 0}, 300 * kUm, 0}, of(board.a, model::kPad));
        QVERIFY(check(*board.builder.finish(), RuleKind::MaskToForeign, 50 * kUm).isPassed());
    }

    /// Whatever the shape: a mask that leaves exactly the pad free leaves no margin.
    void openingsAsLargeAsTheirPadsHaveNoMargin() {
        for (const Nm more : {-2 * kUm, Nm{0}, 2 * kUm}) {
            Board board;
            board.builder.beginLayer(board.mask);
            board.builder.addCircle({{0, 0}, 600 * kUm + more, 0}, of({}));
            board.builder.addLine({{kMm, 0}, {2 * kMm, 0}, 500 * kUm + more, 0}, of({}));
            board.builder.beginLayer(board.top);
            board.builder.addCircle({{0, 0}, 600 * kUm, 0}, of(board.a, model::kPad));
            board.builder.addLine({{kMm, 0}, {2 * kMm, 0}, 500 * kUm, 0}, of(board.a, model::kPad));
            const RuleReport report = check(*board.builder.finish(), RuleKind::MaskToCopper, 50 * kUm);
            QCOMPARE(report.findings.size(), more < 0 ? std::size_t{0} : std::size_t{2});
            for (const model::RuleFinding& finding : report.findings) {
                QVERIFY(std::abs(finding.spacing.distance - static_cast<double>(more) / 2) < 1);
                const model::PointD at = finding.spacing.from;  // on the outline
                const double out = at.x < double{kMm} ? std::hypot(at.x, at.y) - 300e3 : 0.0;
                QVERIFY2(std::abs(out) < double{2 * kUm}, qPrintable(QString::number(out)));
            }
            QCOMPARE(report.notes.size(), more < 0 ? std::size_t{1} : std::size_t{0});
        }
    }
};

QTEST_GUILESS_MAIN(MaskChecksTest)
#include "mask_checks_test.moc"
