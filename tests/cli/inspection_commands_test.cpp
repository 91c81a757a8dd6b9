// clearance, measure and section: what a build or a script asks of a board.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/cli/program.h"

using namespace program;

class InspectionCommandsTest : public QObject {
    Q_OBJECT

private slots:
    void rulesAreCheckedOnEveryLayerTheyAreFor() {
        for (const char* layer : {"L01-TOP_LAYER", "TOP_SOLDER", "TOP_OVERLAY"}) {
            const int code =
                copperscope({"clearance", locations::kSample, "--rules", "default", "--layer", layer}).exitCode;
            QVERIFY2(code == 0 || code == 4, layer);
        }
        QCOMPARE(copperscope({"clearance", locations::kSample, "--rules", "default", "--layer", "TOP_PASTE"}).exitCode,
                 1);
    }

    void clearanceMeasuresThroughTheStackup() {
        const auto through = [](const QStringList& more) {
            return copperscope(QStringList{"clearance", locations::kSample, "--through", "--format", "json"} + more);
        };
        const Outcome all = through({"--worst", "2"});
        QCOMPARE(all.exitCode, 0);
        const QJsonArray listed = QJsonDocument::fromJson(all.out)["through_stackup"].toArray();
        QCOMPARE(listed.size(), 2);
        const double smallest = listed[0]["distance_um"].toDouble();
        QVERIFY(smallest > 0.0 && smallest <= listed[1]["distance_um"].toDouble());
        const QJsonArray nets = listed[0]["nets"].toArray();
        const Outcome two = through({"--nets", nets[0].toString() + ',' + nets[1].toString(), "--below", "1mm"});
        QCOMPARE(two.exitCode, 4);
        QCOMPARE(QJsonDocument::fromJson(two.out)["through_stackup"][0]["distance_um"].toDouble(), smallest);
        const QTemporaryDir folder;
        const Outcome written = through({"--worst", "2", "-o", folder.filePath("report.json")});
        QFile report(folder.filePath("report.json"));
        QVERIFY(written.exitCode == 0 && written.out.isEmpty() && report.open(QFile::ReadOnly));
        QCOMPARE(report.readAll(), all.out);
        QCOMPARE(through({"--layer", "top"}).exitCode, 1);
        QCOMPARE(through({"--rules", "default"}).exitCode, 1);
        QCOMPARE(through({"--nets", "nowhere,nothing"}).exitCode, 1);
    }

    void clearanceTellsABuildWhatIsTooClose() {
        const Outcome all = copperscope({"clearance", locations::kSample, "--worst", "3", "--format", "json"});
        QVERIFY2(all.exitCode == 0, all.err.constData());
        const QJsonArray listed = QJsonDocument::fromJson(all.out)["steps"][0]["clearances"].toArray();
        QCOMPARE(listed.size(), 3);
        QCOMPARE(listed[0]["gap_um"], listed[0]["clearance_um"]);  // the old name
        const double narrowest = listed[0]["clearance_um"].toDouble();
        QVERIFY(narrowest > 0.0 && narrowest <= listed[1]["clearance_um"].toDouble());
        const auto below = [&](double um) {
            return copperscope({"clearance", locations::kSample, "--below", QString::number(um, 'f', 3) + "um"})
                .exitCode;
        };
        QCOMPARE(below(narrowest + 1.0), 4);
        QCOMPARE(below(narrowest - 1.0), 0);
        QCOMPARE(copperscope({"clearance", locations::kSample, "--below", "3 apples"}).exitCode, 1);
        QCOMPARE(copperscope({"clearance", locations::kSample, "--layer", "nowhere"}).exitCode, 1);
    }

    void rulesTellABuildWhatIsBroken() {
        QTemporaryDir folder;
        const auto check = [&](const char* um) {
            QFile file(folder.filePath("rules.json"));
            file.open(QIODevice::WriteOnly);
            file.write(R"({"copperscope_rules": 1, "rules": [{"kind": "copper-copper", "least_um": )");
            file.write(um + QByteArray("}]}"));
            file.close();
            return copperscope({"clearance", locations::kSample, "--rules", file.fileName(), "--format", "json"});
        };
        QCOMPARE(check("1").exitCode, 0);
        const Outcome broken = check("5000");
        QCOMPARE(broken.exitCode, 4);
        const QJsonValue rule = QJsonDocument::fromJson(broken.out)["steps"][0]["rules"][0];
        QCOMPARE(rule["passed"].toBool(true), false);
        QCOMPARE(rule["findings"].toArray().size(), std::min(100, rule["count"].toInt()));
        QVERIFY(rule["findings"][0]["clearance_um"].toDouble() < 5000.0);
        QCOMPARE(check("-1").exitCode, 2);
        QVERIFY(check("-1").err.contains("least_um"));
        QCOMPARE(copperscope({"clearance", locations::kSample, "--rules", "/nowhere.json"}).exitCode, 2);
    }

    void limitsOfRulesHaveATolerance() {
        QTemporaryDir folder;
        QFile file(folder.filePath("rules.json"));
        const Outcome all = copperscope({"clearance", locations::kSample, "--worst", "1", "--format", "json"});
        const double narrowest =
            QJsonDocument::fromJson(all.out)["steps"][0]["clearances"][0]["clearance_um"].toDouble();
        file.open(QIODevice::WriteOnly);
        file.write(R"({"copperscope_rules": 1, "rules": [{"kind": "copper-copper", "least_um": )" +
                   QByteArray::number(narrowest + 0.4, 'f', 3) + "}]}");
        file.close();
        const auto check = [&](const QStringList& more) {
            return copperscope(QStringList{"clearance", locations::kSample, "--rules", file.fileName()} + more);
        };
        const Outcome passed = check({});
        QCOMPARE(passed.exitCode, 0);
        QVERIFY2(passed.out.contains("tolerance of limits 0.500 um"), passed.out.constData());
        QCOMPARE(check({"--tolerance", "0"}).exitCode, 4);
        QCOMPARE(check({"--tolerance", "0.3um"}).exitCode, 4);
        QCOMPARE(check({"--tolerance", "0.45um"}).exitCode, 0);
        QCOMPARE(check({"--tolerance", "1mm"}).exitCode, 1);
        QCOMPARE(check({"--tolerance", "apple"}).exitCode, 1);
    }

    void waivedFindingsDoNotFailABuild() {
        QTemporaryDir folder;
        const QString rules = folder.filePath("rules.json");
        QFile file(rules);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"copperscope_rules": 1, "rules": [{"kind": "copper-copper", "least_um": 200}]})");
        file.close();
        const QString waivers = folder.filePath("waivers.json");
        const auto check = [&](const QStringList& more) {
            return copperscope(QStringList{"clearance", locations::kSample, "--rules", rules} + more);
        };
        QCOMPARE(check({}).exitCode, 4);
        QCOMPARE(check({"--write-waivers", waivers, "--reason", "as built"}).exitCode, 1);  // by whom?
        QCOMPARE(check({"--write-waivers", waivers, "--reason", "as built", "--author", "Me"}).exitCode, 0);
        QCOMPARE(
            check({"--waivers", waivers, "--write-waivers", waivers, "--reason", "again", "--author", "Me"}).exitCode,
            0);
        const Outcome waived = check({"--waivers", waivers, "--format", "json"});
        QCOMPARE(waived.exitCode, 0);
        const QJsonValue rule = QJsonDocument::fromJson(waived.out)["steps"][0]["rules"][0];
        QCOMPARE(rule["count"].toInt(), 0);
        QVERIFY(rule["waived_count"].toInt() > 1);

        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"copperscope_rules": 1, "rules": [{"kind": "copper-copper", "least_um": 1}]})");
        file.close();
        const Outcome gone = check({"--waivers", waivers});
        QCOMPARE(gone.exitCode, 0);
        QVERIFY2(gone.out.contains("no finding there any more"), gone.out.constData());
        QCOMPARE(check({"--waivers", rules}).exitCode, 2);
        QCOMPARE(copperscope({"clearance", locations::kSample, "--waivers", waivers}).exitCode, 1);  // of which rules?
    }

    void reportsAreWrittenToFiles() {
        QTemporaryDir folder;
        for (const char* format : {"text", "json", "csv", "junit", "sarif", "html"}) {
            const QString path = folder.filePath(format);
            const QStringList call{"clearance", locations::kSample, "--rules", "default", "--format", format};
            const Outcome written = copperscope(call + QStringList{"-o", path});
            QVERIFY(written.out.isEmpty());
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.readAll(), copperscope(call).out);
        }
        const QStringList smallest{"clearance", locations::kSample};
        QCOMPARE(copperscope(smallest + QStringList{"--format", "junit"}).exitCode, 1);
        QCOMPARE(copperscope(smallest + QStringList{"-o", "/nowhere/report"}).exitCode, 3);
        const Outcome full = copperscope(smallest + QStringList{"-o", "/dev/full"});
        QCOMPARE(full.exitCode, 3);
        QVERIFY2(full.err.contains("No space left on device"), full.err.constData());
    }

    void rulesAreHeldAgainstLayersAndNets() {
        Outcome printed = copperscope({"clearance", "--rules", "default", "--print"});
        QCOMPARE(printed.exitCode, 0);
        QTemporaryDir folder;
        QFile file(folder.filePath("rules.json"));
        QCOMPARE(copperscope({"clearance", "--rules", "default", "--print", "-o", file.fileName()}).exitCode, 0);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), printed.out);
        file.close();
        file.open(QIODevice::WriteOnly);
        file.write(printed.out.replace("100.0", "5000.0"));
        file.close();
        const auto rules = [&](const QStringList& more) {
            const Outcome outcome = copperscope(
                QStringList{"clearance", locations::kSample, "--rules", file.fileName(), "--format", "json"} + more);
            return QJsonDocument::fromJson(outcome.out)["steps"][0]["rules"].toArray();
        };
        const QJsonArray all = rules({});
        const QJsonValue worst = all[0]["findings"][0];
        const QJsonArray onLayer = rules({"--layer", worst["layer"].toString()});
        QVERIFY(onLayer[0]["count"].toInt() > 0 && onLayer[0]["count"].toInt() < all[0]["count"].toInt());
        for (const QJsonValue& finding : onLayer[0]["findings"].toArray()) {
            QCOMPARE(finding["layer"], worst["layer"]);
        }
        QCOMPARE(onLayer[5]["result"].toString(), "unused");
        const QString nets = worst["nets"][0].toString() + ',' + worst["nets"][1].toString();
        const QJsonArray ofNets = rules({"--nets", nets});
        QCOMPARE(ofNets[0]["findings"][0]["clearance_um"], worst["clearance_um"]);
        for (const QJsonValue& finding : ofNets[0]["findings"].toArray()) {
            QCOMPARE(finding["nets"], worst["nets"]);
        }
        QCOMPARE(ofNets[4]["result"].toString(), "unused");
        const QJsonArray below = rules({"--below", "1um"});
        QCOMPARE(below[0]["count"], all[0]["count"]);
        QCOMPARE(below[0]["result"].toString(), "fail");
        for (const QJsonValue& finding : below[0]["findings"].toArray()) {
            QVERIFY(finding["clearance_um"].toDouble() < 1.0);
        }
        QCOMPARE(copperscope({"clearance", locations::kSample, "--rules", "default", "--layer", "nowhere"}).exitCode,
                 1);
        QCOMPARE(copperscope({"clearance", locations::kSample, "--rules", "default", "--nets", "A,nowhere"}).exitCode,
                 1);
        QCOMPARE(copperscope({"clearance", locations::kSample, "--print"}).exitCode, 1);
    }

    void aStepThatWasNotMeasuredIsNoPass() {
        const QString panel = QString(locations::kTestData) + "/odb/panel";
        const char* const why = "not everything could be checked: steps with copper have no nets";
        for (const QStringList& how : {QStringList(), QStringList("--through")}) {
            const QStringList below = QStringList{"clearance", panel, "--below", "1um"} + how;
            const Outcome run = copperscope(below);
            QVERIFY2(run.exitCode == 4 && run.err.contains(why), run.err.constData());
            QCOMPARE(copperscope(below + QStringList("--allow-incomplete")).exitCode, 0);
            const Outcome named = copperscope(below + QStringList{"--nets", "A,B"});
            QVERIFY2(!named.err.contains(why), named.err.constData());
        }
    }

    /// Boards of a panel have nets of their own.
    void netsOfOneStepOfAPanelAreEnough() {
        const QString panel = QString(locations::kTestData) + "/odb/panel";
        const Outcome both = copperscope({"clearance", panel, "--nets", "A,B"});
        QVERIFY2(both.exitCode == 0 && both.err.contains("step CARD has no net B; it was skipped"),
                 both.err.constData());
        QVERIFY2(both.out.contains("step COUPON") && !both.out.contains("step CARD"), both.out.constData());
        const Outcome rules = copperscope({"clearance", panel, "--nets", "A,B", "--rules", "default"});
        QVERIFY2(rules.err.contains("step CARD has no net B; it was skipped"), rules.err.constData());
        QVERIFY2(rules.out.contains("step COUPON") && !rules.out.contains("step CARD"), rules.out.constData());
        const Outcome none = copperscope({"clearance", panel, "--nets", "A,nowhere"});
        QVERIFY2(none.exitCode == 1 && none.err.contains("the board has no net nowhere"), none.err.constData());
        QCOMPARE(copperscope({"clearance", panel, "--nets", "A,A"}).exitCode, 1);
    }

    /// A rule that could not check something is no pass.
    void incompleteRulesTellABuildToo() {
        QTemporaryDir folder;
        const QString rules = folder.filePath("rules.json");
        QFile file(rules);
        file.open(QIODevice::WriteOnly);
        file.write(R"({"copperscope_rules": 1, "rules": [{"kind": "copper-copper", "least_um": 100}]})");
        file.close();
        const QString board = QString(locations::kTestData) + "/odb/drills";
        const Outcome text = copperscope({"clearance", board, "--rules", rules});
        QCOMPARE(text.exitCode, 4);
        QVERIFY2(text.out.contains("incomplete  copper-copper"), text.out.constData());
        QVERIFY2(text.out.contains("not checked: ") && text.out.contains("the board has no nets"),
                 text.out.constData());
        QVERIFY2(text.err.contains("not everything could be checked: 1 rule incomplete (--allow-incomplete"),
                 text.err.constData());
        const Outcome waived = copperscope({"clearance", board, "--rules", rules, "--write-waivers",
                                            folder.filePath("w.json"), "--reason", "as built", "--author", "Me"});
        QVERIFY2(waived.exitCode == 0 && waived.err.contains("1 rule could not check everything, which no waiver"),
                 waived.err.constData());
        QCOMPARE(copperscope({"clearance", board, "--rules", rules, "--allow-incomplete"}).exitCode, 0);
        const Outcome json = copperscope({"clearance", board, "--rules", rules, "--format", "json"});
        const QJsonValue rule = QJsonDocument::fromJson(json.out)["steps"][0]["rules"][0];
        QCOMPARE(rule["result"].toString(), "incomplete");
        QCOMPARE(rule["passed"].toBool(true), false);
        QVERIFY(rule["unchecked"][0]["count"].toInt() > 0);
        QCOMPARE(rule["unchecked"][0]["reason"].toString(), "the board has no nets");
        const Outcome csv = copperscope({"clearance", board, "--rules", rules, "--format", "csv"});
        QVERIFY2(csv.out.contains(",incomplete,") && csv.out.count('\n') == 2, csv.out.constData());
    }

    /// Logs of builds hold stderr alone: it says what the exit code is about.
    void rulesSayWhyTheyEndWithFour() {
        const QTemporaryDir folder;
        const auto check = [&](const QByteArray& rules, const QStringList& rest) {
            QFile file(folder.filePath("rules.json"));
            file.open(QIODevice::WriteOnly);
            file.write(R"({"copperscope_rules": 1, "rules": [)" + rules + "]}");
            file.close();
            return copperscope(QStringList{"clearance", locations::kSample, "--rules", file.fileName()} + rest);
        };
        const QByteArray broken = R"({"kind": "track-width", "least_um": 90000})";
        const QByteArray unknown = R"({"kind": "track-width", "least_um": 1, "layer": "no such layer"})";
        const QByteArray unused = R"({"kind": "silk-pad", "least_um": 1, "layer": "inner"})";
        const QString report = folder.filePath("r.txt");
        const Outcome both = check(broken + "," + unknown, {"-o", report});
        QCOMPARE(both.exitCode, 4);
        QVERIFY2(both.err.contains("1 rule broken at ") && both.err.contains(" locations, 1 incomplete; see "),
                 both.err.constData());
        const Outcome alone = check(broken, {"-o", report});
        QVERIFY2(alone.exitCode == 4 && alone.err.contains("1 rule broken at ") && alone.out.isEmpty() &&
                     !alone.err.contains("incomplete"),
                 alone.err.constData());
        // A check of nothing is no pass.
        const Outcome nothing = check(unused, {});
        QVERIFY2(nothing.exitCode == 4 && nothing.err.contains("nothing was checked: all rules are unused"),
                 nothing.err.constData());
        QCOMPARE(check(unused, {"--allow-incomplete"}).exitCode, 0);
        const Outcome passed = check(R"({"kind": "track-width", "least_um": 1})", {});
        QVERIFY2(passed.exitCode == 0 && passed.err.isEmpty(), passed.err.constData());
    }

    void measureTellsHowFarThingsAreApart() {
        const auto measure = [](const QStringList& rest) {
            return copperscope(QStringList{"measure", locations::kSample} + rest);
        };
        // The narrowest clearance of the board is the distance of its two nets, and of its two elements.
        const Outcome all = copperscope({"clearance", locations::kSample, "--worst", "1", "--format", "json"});
        const QJsonObject narrowest = onlyOne(QJsonDocument::fromJson(all.out)["steps"][0]["clearances"]);
        const double gap = narrowest["clearance_um"].toDouble() * 1000.0;
        const auto item = [&](const char* prefix, const char* list, int row) {
            return prefix + narrowest[list][row].toVariant().toString();
        };
        for (const auto& [prefix, list] : {std::pair("net:", "nets"), std::pair("element:", "elements")}) {
            const Outcome run =
                measure({"--from", item(prefix, list, 0), "--to", item(prefix, list, 1), "--format", "json"});
            QVERIFY2(run.exitCode == 0, run.err.constData());
            const QJsonObject way = QJsonDocument::fromJson(run.out)["on_layer"].toObject();
            QVERIFY2(std::abs(way["distance_nm"].toDouble() - gap) < 0.01, run.out.constData());
            QCOMPARE(way["ends"][0]["layer"], narrowest["layer"]);
            QCOMPARE(way["gap_nm"], way["spacing_nm"]);  // old names stay beside the new ones
            QVERIFY(QJsonDocument::fromJson(run.out).object().contains("remarks"));
            QCOMPARE(way["relation"].toString(), QString("apart"));
        }
        const QStringList nets = {"--from", item("net:", "nets", 0), "--to", item("net:", "nets", 1)};
        QCOMPARE(measure(nets + QStringList{"--below", QString::number(gap / 1000 + 1) + "um"}).exitCode, 4);
        QCOMPARE(measure(nets + QStringList{"--below", QString::number(gap / 1000 - 1) + "um"}).exitCode, 0);
        const Outcome csv = measure(nets + QStringList{"--format", "csv"});
        QVERIFY(csv.out.startsWith("kind,distance um") && csv.out.count('\n') == 4);
        QVERIFY(measure({"--from", "part:U1", "--to", "edge"}).out.contains("on one layer"));
        QVERIFY(measure({"--from", "at:1mm,-2mm", "--to", "at:4mm,2mm"}).out.contains("5.000000 mm"));
    }

    void measureSaysWhatItDoesNotKnow() {
        const auto measure = [](const QString& from) {
            return copperscope({"measure", locations::kSample, "--from", from, "--to", "edge"});
        };
        for (const auto& [from, why] :
             {std::pair("net:GNDD", "did you mean GND"), std::pair("pin:U1.999", "no pin of U1"),
              std::pair("element:99999999", "numbered from 0"), std::pair("at:1,2", "a number with um"),
              std::pair("at:1mm", "X,Y"), std::pair("apple", "names no item"), std::pair("7/net:GND", "no copy 7"),
              std::pair("at:1mm,1mm,nowhere", "no layer nowhere")}) {
            const Outcome run = measure(from);
            QVERIFY2(run.exitCode == 1 && run.err.contains(why), run.err.constData());
        }
        QVERIFY(measure("edge").out.contains("both are the same"));
    }

    /// Its pin U1.1 has two pads, its name R1 two components.
    void measureTakesAllThatHasTheName() {
        const QTemporaryDir folder;
        QFile board(folder.filePath("names.kicad_pcb"));
        QVERIFY(board.open(QFile::WriteOnly));
        board.write("(kicad_pcb (version 20241229) (layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal)) (net 1 \"GND\")\n");
        const auto part = [&](const char* name, int x, const char* pads) {
            board.write(QString("(footprint \"T:x\" (layer \"F.Cu\") (at %1 10) (property \"Reference\" \"%2\") %3)\n")
                            .arg(QString::number(x), name, pads)
                            .toUtf8());
        };
        constexpr const char* kPad = "(pad \"1\" smd rect (at 0 0) (size 1 1) (layers \"F.Cu\"))";
        part(
            "U1", 15,
            "(pad \"1\" smd rect (at -5 0) (size 1 1) (layers \"F.Cu\") (net 1 \"GND\")) (pad \"1\" smd rect (at 5 0) "
            "(size 1 1) (layers \"F.Cu\") (net 1 \"GND\")) (pad \"2\" smd rect (at 8 0) (size 1 1) (layers \"F.Cu\"))");
        part("R1", 40, kPad);
        part("R1", 50, kPad);
        part("", 60, kPad);
        board.write(")");
        board.close();
        const auto measure = [&](const char* from, const char* to, const QStringList& more = {}) {
            return copperscope(QStringList{"measure", board.fileName(), "--from", from, "--to", to} + more);
        };
        const Outcome pads = measure("pin:U1.1", "pin:U1.2", {"--below", "2.1mm", "--format", "json"});
        QCOMPARE(pads.exitCode, 4);
        const QJsonObject json = QJsonDocument::fromJson(pads.out).object();
        QCOMPARE(json["on_layer"]["distance_nm"].toDouble(), 2e6);
        QVERIFY2(json["notes"].toVariant().toStringList().join('\n').contains(
                     "pin U1.1 has 2 pads (10, -10 mm; 20, -10 mm)"),
                 pads.out.constData());
        const Outcome parts = measure("at:52mm,-10mm", "pin:R1.1", {"--format", "csv"});
        QVERIFY2(parts.out.contains("in_plane,1500.000,"), parts.out.constData());
        QVERIFY2(parts.err.contains("2 components are called R1 (40, -10 mm; 50, -10 mm)"), parts.err.constData());
        const Outcome nameless = measure("part:", "edge");
        QVERIFY2(nameless.exitCode == 1 && nameless.err.contains("write net:NAME"), nameless.err.constData());
    }

    void aNameOfTwoLayersNamesNone() {
        const QTemporaryDir folder;
        QFile board(folder.filePath("layers.kicad_pcb"));
        QVERIFY(board.open(QFile::WriteOnly));
        board.write(
            "(kicad_pcb (version 20241229) (layers (0 \"F.Cu\" signal \"Sig\") (2 \"B.Cu\" signal \"Sig\")) (net 1 "
            "\"GND\"))");
        board.close();
        const QStringList measure{"measure", board.fileName(), "--from", "at:1mm,1mm,Sig", "--to", "at:2mm,1mm"};
        const QStringList section{"section", board.fileName(), "--line", "0,0,9,0", "--layers", "Sig"};
        const QStringList clearance{"clearance", board.fileName(), "--layer", "Sig"};
        for (const QStringList& command : {measure, section, clearance}) {
            const Outcome run = copperscope(command);
            QVERIFY2(run.exitCode == 1 && run.err.contains("2 layers are called Sig"), run.err.constData());
        }
    }

    void measureFollowsNets() {
        const auto path = [](const QStringList& rest) {
            return copperscope(QStringList{"measure", locations::kSample, "--path", "GND"} + rest);
        };
        const Outcome run = path({"--from", "net:GND", "--to", "net:GND", "--format", "json"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        QCOMPARE(QJsonDocument::fromJson(run.out)["length_nm"].toDouble(), 0.0);
        const Outcome off = path({"--from", "edge", "--to", "net:GND"});
        QVERIFY2(off.exitCode == 1 && off.err.contains("has no copper of net GND"), off.err.constData());
        QCOMPARE(path({"--from", "edge", "--to", "net:GND", "--below", "1mm"}).exitCode, 1);
    }

    void clearanceMapsAreWrittenAsPictureAndTable() {
        const QTemporaryDir folder;
        const auto map = [&](const QString& name, const QStringList& more = {}) {
            return copperscope(
                QStringList{"clearance", locations::kSample, "--map", name, "--layer", "L01-TOP_LAYER"} + more,
                folder.path());
        };
        const QStringList window{"--window", "1,1,6,4", "--resolution", "10um"};
        const Outcome drawn = map("map.png", window);
        QVERIFY2(drawn.exitCode == 0, drawn.err.constData());
        const QSize size = pngSize(folder.filePath("map.png"));
        QVERIFY(size.width() > 500 && size.height() >= 300);  // with the legend

        QCOMPARE(map("map.csv", {"--reach", "0.4mm"}).exitCode, 0);
        QFile table(folder.filePath("map.csv"));
        QVERIFY(table.open(QIODevice::ReadOnly));
        const QList<QByteArray> rows = table.readAll().trimmed().split('\n');
        QCOMPARE(rows.front(), QByteArray("step,copy,layer,x_nm,y_nm,spacing_nm,net_a,net_b"));
        QVERIFY(rows.size() > 100);
        for (const QByteArray& row : rows.mid(1)) {
            const QList<QByteArray> cells = row.split(',');
            QVERIFY(cells[5].toInt() > 0 && cells[5].toInt() <= 400'000);
            QVERIFY(cells[2] == "L01-TOP_LAYER" && cells[6] != cells[7]);
        }

        const auto isRefused = [&](const Outcome& run, int code, const char* why) {
            QVERIFY2(run.exitCode == code && run.err.contains(why), run.err.constData());
        };
        isRefused(map("map.jpg"), 1, "written as .png or .csv");
        isRefused(map("none/map.png", window), 3, "No such file");
        isRefused(map("huge.png", {"--resolution", "0.1um"}), 1, "cells is too large: a picture has 33554432 at most");
        isRefused(map("huge.csv", {"--resolution", "5um"}), 1, "a table has 4000000 at most");
        isRefused(map("map.png", {"--reach", "11mm"}), 1, "up to 10 mm, not 11mm");
        isRefused(map("map.png", {"--window", "1,1,1,2"}), 1, "--window is empty");
        isRefused(map("map.png", {"--window", "90,90,91,91"}), 1, "--window lies beside the board");
        isRefused(map("map.png", {"--rules", "default"}), 1, "--map");
        isRefused(copperscope({"clearance", locations::kSample, "--map", "m.png", "--layer", "nowhere"}), 1,
                  "no copper layer nowhere");
        isRefused(copperscope({"clearance", locations::kSample, "--reach", "1mm"}), 1, "--map");
        QVERIFY(!QFile::exists(folder.filePath("huge.png")));
    }

    void oldNamesOfSolderMasksStillWork() {
        const Outcome run = copperscope({"section", locations::kTestData + QStringLiteral("/odb/everything"), "--line",
                                         "0,1,9,1", "--layers", "SMT coat"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        QVERIFY2(run.err.contains("\"SMT coat\" is now named \"SMT solder mask\""), run.err.constData());
    }

    /// A track of 2 mm across the right edge, at x = 10 mm.
    void sectionLeavesOutWhatIsMilledAway() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("edge.kicad_pcb");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "(kicad_pcb (version 20241229) (general (thickness 1.6)) (layers (0 \"F.Cu\" signal) (2 \"B.Cu\" signal) "
            "(25 \"Edge.Cuts\" user)) (net 0 \"\") (net 1 \"A\") (gr_rect (start 0 0) (end 10 10) (stroke (width "
            "0.1) (type solid)) (fill no) (layer \"Edge.Cuts\")) (segment (start 2 5) (end 12 5) (width 2) (layer "
            "\"F.Cu\") (net 1)) (segment (start 2 8) (end 4 8) (width 1) (layer \"F.Cu\") (net 1)))");
        file.close();
        const auto last = [&](const QStringList& more) {
            const Outcome run = copperscope(
                QStringList{"section", path, "--line", "-1,-5,20,-5", "--layers", "F.Cu", "--format", "json"} + more);
            const QJsonArray pieces = QJsonDocument::fromJson(run.out).object()["pieces"].toArray();
            return std::pair(pieces.last()["to_nm"].toDouble(), run.err.contains("left out as milled away"));
        };
        QCOMPARE(last({}), std::pair(11e6, true));
        QCOMPARE(last({"--as-designed"}), std::pair(14e6, false));
    }

    void sectionShowsWhatALineCuts() {
        const Outcome run =
            copperscope({"section", locations::kSample, "--line", "-1000,20,1000,20.5", "--format", "json"});
        QVERIFY2(run.exitCode == 0, run.err.constData());
        const QJsonObject section = QJsonDocument::fromJson(run.out).object();
        QSet<QString> layers;
        for (const QJsonValue& piece : section["pieces"].toArray()) {
            layers.insert(piece["layer"].toString());
            const double lower = piece["to_nm"].toDouble() - piece["from_nm"].toDouble();
            const double upper = piece["upper_to_nm"].toDouble() - piece["upper_from_nm"].toDouble();
            QVERIFY(lower >= 0.0 && upper >= 0.0 && lower + upper > 0.0);
            QVERIFY(!piece["material"].toString().isEmpty());
            QVERIFY(piece["bottom_nm"].toInt() <= piece["top_nm"].toInt());
        }
        QVERIFY2(layers.size() > 3, run.out.constData());
        QXmlStreamReader svg(copperscope({"section", locations::kSample, "--line", "-1000,20,1000,20.5"}).out);
        while (!svg.atEnd()) {
            svg.readNext();
        }
        QVERIFY2(!svg.hasError(), qPrintable(svg.errorString()));
        const Outcome beside =
            copperscope({"section", locations::kSample, "--line", "900,900,901,900", "--format", "csv"});
        QCOMPARE(beside.exitCode, 0);
        QCOMPARE(beside.out.count('\n'), 1);
        for (const char* line : {"1,2,3", "1,2,1,2", "1,2", "0,0,5000,0"}) {
            QCOMPARE(copperscope({"section", locations::kSample, "--line", line}).exitCode, 1);
        }
        QCOMPARE(copperscope({"section", locations::kSample, "--line", "0,0,1,1", "--layers", "nowhere"}).exitCode, 1);
    }
};

QTEST_GUILESS_MAIN(InspectionCommandsTest)
#include "inspection_commands_test.moc"
