// What the netlist check lists of a jumper that joins two nets, and of pins without one.
#include "ui/netlist_check/netlist_check_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::NetId;
using ui::NetlistCheckModel;

class NetlistCheckModelTest : public QObject {
    Q_OBJECT

private slots:
    void aNetTieIsListedAndIsNoShort() {
        model::DocumentBuilder builder;
        const NetId nets[] = {builder.addNet("A"), builder.addNet("B")};
        builder.beginLayer(addLayer(builder, "top"));
        model::Component jumper;
        jumper.refdes = "JP1";
        std::vector<model::Pin> pins(2);
        pins[0].net = nets[0];
        pins[1].net = nets[1];
        builder.addComponent(jumper, pins);
        for (std::uint32_t pin = 0; pin < 2; ++pin) {
            model::DocumentBuilder::Origin origin = of(nets[pin], model::kPad);
            origin.subnet = builder.addSubnet({nets[pin], model::SubnetKind::PinPads, model::PinId{pin}});
            builder.addCircle({{static_cast<model::Nm>(pin) * 2 * kMm, 0}, kMm, 0}, origin);
        }
        const model::ElementId bridge = builder.addLine({{0, 0}, {2 * kMm, 0}, 100 * kUm, 0}, of({}));
        const std::shared_ptr<const model::Document> board = builder.finish();
        base::Progress progress;
        NetlistCheckModel findings;
        const QAbstractItemModelTester keepsPromises(&findings);
        findings.setChecks(board, *model::checkAllNets(*board, progress));
        QCOMPARE(findings.summary(), "no shorts, no open nets, no floating copper, 1 net tie");
        QCOMPARE(findings.rowCount(), 1);
        QStringList cells;
        for (const int column :
             {NetlistCheckModel::Kind, NetlistCheckModel::Nets, NetlistCheckModel::What, NetlistCheckModel::Layer}) {
            cells << findings.index(0, column).data().toString();
        }
        QCOMPARE(cells.join("|"), "Net tie|A, B|Joined by JP1; assumed from its name and its copper|top");
        QVERIFY(findings.elementsOf(findings.finding(0)) == std::vector{bridge});
    }

    /// "No shorts" would be a pass that nobody looked for.
    void netsOfTheCopperAreNotComparedWithIt() {
        const auto summaryOf = [](std::initializer_list<const char*> nets, int pads = 1) {
            model::DocumentBuilder builder;
            std::vector<NetId> ids;
            for (const char* net : nets) {
                ids.push_back(builder.addNet(net));
            }
            builder.beginLayer(addLayer(builder, "top"));
            for (int pad = 0; pad < pads; ++pad) {
                builder.addCircle({{pad * 2 * kMm, 0}, kMm, 0}, of(ids.empty() ? NetId{} : ids.front(), model::kPad));
            }
            const std::shared_ptr<const model::Document> board = builder.finish();
            base::Progress progress;
            NetlistCheckModel findings;
            findings.setChecks(board, *model::checkAllNets(*board, progress));
            return findings.summary();
        };
        QCOMPARE(summaryOf({"$1", "$12"}), "nothing to compare: the nets follow from the copper, no floating copper");
        QCOMPARE(summaryOf({"$1"}, 2), "no shorts, 1 open net, no floating copper");  // nets of the job, called so
        QCOMPARE(summaryOf({"$1", "VCC"}), "no shorts, no open nets, no floating copper");
        QCOMPARE(summaryOf({"$", "$1N2"}), "no shorts, no open nets, no floating copper");
        QCOMPARE(summaryOf({}), "nothing to compare: there are no nets, no floating copper");
    }

    void aPinWithoutANetOnCopperOfOneIsListed() {
        model::DocumentBuilder builder;
        const NetId net = builder.addNet("A");
        builder.beginLayer(addLayer(builder, "top"));
        model::Component part;
        part.refdes = "U1";
        std::vector<model::Pin> pins(1);
        pins[0].name = builder.string("3");
        builder.addComponent(part, pins);
        const model::ElementId pad = builder.addCircle({{0, 0}, kMm, 0}, of({}, model::kPad));
        const model::ElementId track = builder.addLine({{0, 0}, {2 * kMm, 0}, 100 * kUm, 0}, of(net));
        const std::shared_ptr<const model::Document> board = builder.finish();
        base::Progress progress;
        NetlistCheckModel findings;
        findings.setChecks(board, *model::checkAllNets(*board, progress));
        QCOMPARE(findings.summary(),
                 "no shorts, no open nets, no floating copper, 1 pin without a net that touches one");
        QCOMPARE(findings.index(0, NetlistCheckModel::Kind).data().toString(), "No net");
        QCOMPARE(findings.index(0, NetlistCheckModel::What).data().toString(), "U1.3 has no net and touches A");
        QVERIFY(findings.elementsOf(findings.finding(0)) == (std::vector{pad, track}));
    }
};

QTEST_GUILESS_MAIN(NetlistCheckModelTest)
#include "netlist_check_model_test.moc"
