// Reports of KiCad's own design rule check (boards/kicad/drc), with the limits they state: every pair it reports is
// found by our rules on a layer it names, no farther apart. Its lists end after 499 locations of a kind and name every
// segment, so what it does not report is not looked at.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QtTest>
#include <map>
#include <set>

#include "model/clearance/rule_report.h"
#include "model/design_rules/design_rule_check.h"
#include "model/formats/registry.h"
#include "model/text/net_names.h"
#include "tests/locations.h"

namespace {

constexpr double kForgivenNm = 1000.0;

using Nets = std::set<std::string>;

/// "Track [GND] on F.Cu, length 1 mm": "GND"; of an item without a net, as an NPTH, "".
std::string netOf(const QJsonValue& item) {
    static const QRegularExpression kNet(QStringLiteral("\\[(.*?)\\]"));
    return model::readableName(kNet.match(item["what"].toString()).captured(1).toStdString());
}

Nets netsOf(const QJsonObject& violation) {
    Nets nets;
    for (const QJsonValue item : violation["items"].toArray()) {
        nets.insert(netOf(item));
    }
    return nets;
}

struct Report {
    QJsonObject limitsMm;
    QJsonArray violations;
};

Report reportOf(const QString& board) {
    QFile file(QString::fromStdString((locations::boards() / "kicad" / "drc").string()) + '/' + board + ".json");
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
    return {all["limits_mm"].toObject(), all["violations"].toArray()};
}

model::RuleTable rulesOf(const QJsonObject& limits) {
    const auto nm = [&](const char* name) {
        return static_cast<model::Nm>(limits[QLatin1String(name)].toDouble() * 1e6);
    };
    return {{},
            {{model::RuleKind::CopperToCopper, nm("clearance") + 1, {}},
             {model::RuleKind::CopperToHole, nm("hole_clearance") + 1, {}}},
            0};
}

/// The smallest spacing that was found between nets, nm.
std::map<Nets, double> smallestOf(const model::Document& board, const model::RuleReport& report, std::size_t rule) {
    std::map<Nets, double> smallest;
    const auto nameOf = [&](model::ElementId element) {
        const model::NetId net = board.elements.net[element.row()];
        const bool isBare = (board.elements.flags[element.row()] & model::kHole) != 0 &&
                            !model::isPlatedHole(board.elements.flags[element.row()]);
        return net.isValid() && !isBare ? model::readableName(board.nets[net.row()].name) : std::string();
    };
    for (const model::RuleFinding& finding : report.findings) {
        if (finding.rule == rule) {
            const Nets nets{nameOf(finding.a), nameOf(finding.b)};
            const auto known = smallest.try_emplace(nets, finding.spacing.distance).first;
            known->second = std::min(known->second, finding.spacing.distance);
        }
    }
    return smallest;
}

}  // namespace

class KicadDrcTest : public QObject {
    Q_OBJECT

private slots:
    void everyReportedPairIsFound_data() {
        QTest::addColumn<QString>("board");
        QTest::newRow("StickHub") << QStringLiteral("StickHub");
        QTest::newRow("RoyalBlue54L-Feather") << QStringLiteral("RoyalBlue54L-Feather");
    }
    void everyReportedPairIsFound() {
        QFETCH(QString, board);
        const Report theirs = reportOf(board);
        QVERIFY(theirs.violations.size() > 500);
        base::Progress progress;
        const auto document =
            model::readBoard(locations::boards() / "kicad" / (board.toStdString() + ".tgz"), {}, progress);
        QVERIFY(document);
        const auto ours = model::checkRules(**document, rulesOf(theirs.limitsMm), progress);
        QVERIFY(ours);
        const char* const kinds[] = {"clearance", "hole_clearance"};
        for (std::size_t rule = 0; rule < 2; ++rule) {
            const std::map<Nets, double> smallest = smallestOf(**document, *ours, rule);
            for (const QJsonValue value : theirs.violations) {
                const QJsonObject violation = value.toObject();
                const Nets nets = netsOf(violation);
                if (violation["kind"] != QLatin1String(kinds[rule])) {
                    continue;
                }
                const auto found = smallest.find(nets);
                QVERIFY2(found != smallest.end(),
                         qPrintable(QString::fromStdString(*nets.begin() + ", " + *nets.rbegin())));
                QVERIFY(found->second <= violation["actual_mm"].toDouble() * 1e6 + kForgivenNm);
            }
        }
    }
};

QTEST_APPLESS_MAIN(KicadDrcTest)
#include "kicad_drc_test.moc"
