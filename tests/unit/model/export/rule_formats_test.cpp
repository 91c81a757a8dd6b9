// Reports on rules for build servers, code hosts and people: each is read back by a reader of its format.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QXmlStreamReader>
#include <QtTest>

#include "model/board/document_builder.h"
#include "model/design_rules/waived_check.h"
#include "model/export/clearance_export.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::ReportFormat;
using model::RuleKind;
using model::RuleTable;

namespace {

constexpr const char* kNet = "<b>&\"x\"";

/// Pairs of pads 80 um apart, as many as wanted, of nets with markup in their names; holes that say no span.
std::shared_ptr<const model::Document> boardOf(int pairs) {
    model::DocumentBuilder builder;
    builder.job().step = "pcb";
    builder.job().name = "job <1>";
    const model::LayerId top = addLayer(builder, "top & more");
    const model::LayerId open = addLayer(builder, "open", model::LayerType::Drill);
    builder.beginLayer(top);
    for (int i = 0; i < pairs; ++i) {
        const std::string number = std::to_string(i);
        const model::Nm y = i * 2 * kMm;
        builder.addCircle({{0, y}, 200 * kUm, 0}, of(builder.addNet(kNet + number)));
        builder.addCircle({{280 * kUm, y}, 200 * kUm, 0}, of(builder.addNet("B" + number)));
    }
    builder.beginLayer(open);
    builder.addCircle({{-9 * kMm, 0}, 300 * kUm, 0}, flagged(model::kHole));
    return builder.finish();
}

/// Broken, incomplete, unused, off and passed, in this order.
const RuleTable kRules{{},
                       {{RuleKind::CopperToCopper, 100 * kUm, {}},
                        {RuleKind::CopperToHole, 100 * kUm, {}},
                        {RuleKind::AnnularRing, 100 * kUm, {}, true, {model::HoleClass::Microvia}},
                        {RuleKind::MaskSliver, 100 * kUm, {}, false},
                        {RuleKind::HoleToHole, 100 * kUm, {}}}};

const model::ReportContext kContext{"boards/new/../my job.tgz", "0.7.0"};

/// A check with the first finding waived, and a waiver of a location that is fine.
struct Checked {
    explicit Checked(int pairs) : board(boardOf(pairs)) {
        base::Progress progress;
        const model::SideNames names(*board);
        model::Waiver said;
        said.reason = "looked <at> & fine";
        said.author = "Me";
        said.date = "2026-11-23";
        const model::RuleReport first = *model::checkRules(*board, kRules, progress);
        waivers.push_back(model::waiverOf(*board, names, kRules, first.findings[0], said));
        waivers.push_back(waivers[0]);
        waivers[1].from.x += kMm;
        steps.push_back({board.get(), *model::checkRules(*board, kRules, waivers, progress)});
    }
    [[nodiscard]] QByteArray report(ReportFormat format, std::size_t most = 100) const {
        return QByteArray::fromStdString(model::ruleReport(kRules, steps, format, most, kContext));
    }

    std::shared_ptr<const model::Document> board;
    std::vector<model::Waiver> waivers;
    std::vector<model::StepRules> steps;
};

struct Case {
    QString name;
    QString result;  ///< of the element in it; empty: passed
    QString message;
};

std::vector<Case> casesOf(QXmlStreamReader& xml) {
    std::vector<Case> cases;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == u"testcase") {
            cases.push_back({xml.attributes().value("name").toString(), {}, {}});
        } else if (!cases.empty() && (xml.name() == u"failure" || xml.name() == u"error" || xml.name() == u"skipped")) {
            cases.back().result = xml.name().toString();
            cases.back().message = xml.attributes().value("message").toString();
        }
    }
    return cases;
}

}  // namespace

class RuleFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void textAndTablesSetWaivedFindingsApart() {
        const Checked checked(3);
        const QByteArray text = checked.report(ReportFormat::Text);
        for (const char* part : {"2 locations, 1 waived\n", "waived: looked <at> & fine (Me, 2026-11-23)\n",
                                 "no finding there any more\n"}) {
            QVERIFY2(text.contains(part), text.constData());
        }
        const QStringList rows = QString::fromUtf8(checked.report(ReportFormat::Csv)).split('\n');
        const auto columns = rows[0].count(',');
        QCOMPARE(rows.filter("waived").size(), 1);
        QCOMPARE(rows.filter("waiver gone").size(), 1);
        for (const QString& row : rows.filter("wai")) {
            QVERIFY2(row.count(',') >= columns, qPrintable(row));
        }
        const QJsonValue step = QJsonDocument::fromJson(checked.report(ReportFormat::Json))["steps"][0];
        QCOMPARE(step["rules"][0]["waived_count"].toInt(), 1);
        QCOMPARE(step["rules"][0]["waived"][0]["waiver"].toString(), "looked <at> & fine (Me, 2026-11-23)");
        QCOMPARE(step["waivers"][0]["state"].toString(), "gone");
        QCOMPARE(step["waivers"][0]["waiver"].toInt(), 2);
    }

    void tablesSayWhatTheyDoNotList() {
        const Checked checked(4);
        const auto unlisted = [&](std::size_t most) {
            return QString::fromUtf8(checked.report(ReportFormat::Csv, most)).split('\n').filter(",not listed,");
        };
        QVERIFY(unlisted(3).isEmpty());
        QCOMPARE(unlisted(1).size(), 1);
        QVERIFY2(unlisted(1)[0].contains("2 more locations are not listed"), qPrintable(unlisted(1)[0]));
        QCOMPARE(unlisted(1)[0].count(','), checked.report(ReportFormat::Csv).split('\n')[0].count(','));
        QCOMPARE(unlisted(0).filter("1 more waived location is not listed").size(), 1);
    }

    void junitHasATestForEachLocation() {
        const Checked checked(4);
        const QByteArray report = checked.report(ReportFormat::Junit, 2);
        QXmlStreamReader xml(report);
        QVERIFY(xml.readNextStartElement() && xml.name() == u"testsuites");
        const auto total = [&, attributes = xml.attributes()](const char* name) {
            return attributes.value(QLatin1String(name)).toInt();
        };
        const std::vector<Case> cases = casesOf(xml);
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        const auto of = [&](const char* result) {
            std::vector<Case> some = cases;
            std::erase_if(some, [&](const Case& c) { return c.result != QLatin1String(result); });
            return some;
        };
        QCOMPARE(of("failure").size(), std::size_t{3});  // two that are listed, and the others
        QVERIFY2(of("failure")[0].name.contains("<b>&\"x\""), qPrintable(of("failure")[0].name));
        QVERIFY(!of("failure")[0].name.contains("element"));
        QVERIFY(report.contains(", dot\n80.000 um of 100.0 um</failure>"));
        QCOMPARE(of("failure")[0].message, "80.000 um of 100.0 um");
        QCOMPARE(of("failure")[2].name, "further locations");
        QCOMPARE(of("failure")[2].message, "1 more are not listed");
        QVERIFY(of("error").size() == 1 && of("error")[0].message.contains("does not say which copper layers"));
        const std::vector<Case> skipped = of("skipped");
        QCOMPARE(skipped.size(), std::size_t{4});  // waived, unused, off, a waiver without a finding
        QVERIFY(skipped[0].message.endsWith("looked <at> & fine (Me, 2026-11-23)"));
        QVERIFY(skipped[1].message.startsWith("unused") && skipped[2].message == "the rule is off");
        QVERIFY(skipped[3].message == "waiver gone" && skipped[3].name.endsWith("no finding there any more"));
        QCOMPARE(of("").size(), std::size_t{1});
        QCOMPARE(total("tests"), static_cast<int>(cases.size()));
        QCOMPARE(total("failures"), 3);
        QCOMPARE(total("errors"), 1);
        QCOMPARE(total("skipped"), 4);
    }

    void sarifHasWhatCodeHostsAskFor() {
        const Checked checked(3);
        const QJsonDocument document = QJsonDocument::fromJson(checked.report(ReportFormat::Sarif));
        QCOMPARE(document["version"].toString(), "2.1.0");
        QVERIFY(document["$schema"].toString().contains("sarif-2.1.0"));
        const QJsonValue run = document["runs"][0];
        QCOMPARE(run["tool"]["driver"]["name"].toString(), "Copperscope");
        const QJsonArray rules = run["tool"]["driver"]["rules"].toArray();
        QCOMPARE(rules.size(), 5);
        std::map<QString, int> kinds;
        int suppressed = 0;
        for (const QJsonValue result : run["results"].toArray()) {
            QVERIFY(result["message"]["text"].isString() && result["suppressions"].isArray());
            QCOMPARE(rules[result["ruleIndex"].toInt()]["id"], result["ruleId"]);
            const QJsonValue location = result["locations"][0];
            QCOMPARE(location["physicalLocation"]["artifactLocation"]["uri"].toString(), "boards/my%20job.tgz");
            const bool isFailed = result["kind"].toString() == "fail";
            QCOMPARE(result["level"].toString(), isFailed ? "error" : "none");
            QCOMPARE(location["logicalLocations"].toArray().size(), isFailed ? 4 : 1);
            ++kinds[result["kind"].toString()];
            for (const QJsonValue suppression : result["suppressions"].toArray()) {
                ++suppressed;
                QCOMPARE(suppression["kind"].toString(), "external");
                QCOMPARE(suppression["justification"].toString(), "looked <at> & fine (Me, 2026-11-23)");
            }
        }
        QCOMPARE(kinds["fail"], 3);
        QCOMPARE(kinds["open"], 1);
        QCOMPARE(kinds["notApplicable"], 1);
        QCOMPARE(kinds["pass"], 1);
        QCOMPARE(suppressed, 1);
        const QJsonValue notes = run["invocations"][0]["toolExecutionNotifications"];
        QVERIFY(notes[0]["message"]["text"].toString().endsWith("no finding there any more"));
    }

    void pagesAreWholeAndSmall() {
        const Checked checked(400);
        const QByteArray page = checked.report(ReportFormat::Html, 300);
        QVERIFY(page.size() < 600'000);
        QXmlStreamReader xml(page);
        int pictures = 0;
        int paths = 0;
        QString text;
        while (!xml.atEnd()) {
            xml.readNext();
            pictures += xml.isStartElement() && xml.name() == u"svg" ? 1 : 0;
            paths += xml.isStartElement() && xml.attributes().value("class") == u"a" && xml.name() == u"path" ? 1 : 0;
            QVERIFY(xml.name() != u"script" && xml.attributes().value("src").isEmpty());
            text += xml.isCharacters() ? xml.text().toString() : QString();
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(pictures, 301);  // and that of the waived one
        QCOMPARE(paths, 301);
        for (const char* part :
             {"job <1>", "<b>&\"x\"", "waived: looked <at> & fine", "99 more locations are not listed",
              "no finding there any more", "80.0 µm", "FAIL: 399 locations"}) {
            QVERIFY2(text.contains(QString::fromUtf8(part)), part);
        }
    }

    /// The exit code is 4 then, and no report may look like a pass.
    void reportsSayThatNothingWasChecked() {
        const RuleTable unused{{}, {kRules.rules[2], kRules.rules[3]}};
        const auto board = boardOf(1);
        base::Progress progress;
        const std::vector<model::StepRules> steps{{board.get(), *model::checkRules(*board, unused, progress)}};
        QVERIFY(model::verdictOf(unused, steps[0].report, 0) == model::Verdict::Unused);
        const auto report = [&](ReportFormat format) {
            return QByteArray::fromStdString(model::ruleReport(unused, steps, format, 100, kContext));
        };
        const char* const said = "nothing was checked: all rules are unused";
        QVERIFY(report(ReportFormat::Text).endsWith(QByteArray(said) + '\n'));
        const QByteArray page = report(ReportFormat::Html);
        QVERIFY2(page.contains("<p class=\"incomplete\">" + QByteArray(said)) && !page.contains("<p class=\"pass\">"),
                 page.constData());
        const QByteArray junit = report(ReportFormat::Junit);
        QVERIFY2(junit.contains("errors=\"1\""), junit.constData());
        QXmlStreamReader xml(junit);
        const std::vector<Case> cases = casesOf(xml);
        QVERIFY(!xml.hasError());
        QCOMPARE(cases.back().result, QString("error"));
        QCOMPARE(cases.back().message, QString(said));
        const QJsonValue run = QJsonDocument::fromJson(report(ReportFormat::Sarif))["runs"][0];
        const QJsonArray notes = run["invocations"][0]["toolExecutionNotifications"].toArray();
        QCOMPARE(notes.last()["message"]["text"].toString(), QString(said));
        for (const ReportFormat format : {ReportFormat::Text, ReportFormat::Html, ReportFormat::Junit}) {
            QVERIFY(!Checked(1).report(format).contains(said));
        }
    }

    /// A plane that is far larger than the picture is cut to it.
    void picturesHoldWhatIsSeenAlone() {
        model::DocumentBuilder builder;
        const model::LayerId top = addLayer(builder, "top");
        const model::NetId a = builder.addNet("A");
        const model::NetId b = builder.addNet("B");
        builder.beginLayer(top);
        builder.addLine({{-500 * kMm, 0}, {500 * kMm, 0}, 100 * kUm, 0}, of(a));
        builder.addLine({{0, 150 * kUm}, {0, 500 * kMm}, 100 * kUm, 0}, of(b));
        const auto board = builder.finish();
        base::Progress progress;
        const RuleTable rules{{}, {{RuleKind::CopperToCopper, 100 * kUm, {}}}};
        const std::vector<model::StepRules> steps{{board.get(), *model::checkRules(*board, rules, progress)}};
        const QString page = QString::fromStdString(model::ruleReport(rules, steps, ReportFormat::Html, 9, kContext));
        QRegularExpressionMatchIterator path =
            QRegularExpression("<path class=\"[ab]\" d=\"([^\"]*)\"").globalMatch(page);
        int paths = 0;
        for (; path.hasNext(); ++paths) {
            for (const QString& number :
                 path.next().captured(1).split(QRegularExpression("[MLZ ]"), Qt::SkipEmptyParts)) {
                QVERIFY2(number.toInt() >= 0 && number.toInt() <= 960, qPrintable(number));
            }
        }
        QCOMPARE(paths, 2);
    }
};

QTEST_GUILESS_MAIN(RuleFormatsTest)
#include "rule_formats_test.moc"
