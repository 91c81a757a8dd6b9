#include "model/formats/kicad/project.h"

#include <QtTest>

using namespace model;

class ProjectTest : public QObject {
    Q_OBJECT

private slots:
    void classesAreAssignedByNameAndPattern() {
        Diagnostics diagnostics;
        const kicad::Project project = kicad::readProject(
            R"({"text_variables": {"BOARD": "X1"}, "net_settings": {
                "classes": [{"name": "Default"}, {"name": "Old", "nets": ["OLD1"]}],
                "netclass_assignments": {"A{slash}B": ["Fast", "Other"], "C": "Slow", "D": null},
                "netclass_patterns": [{"netclass": "Power", "pattern": "V?C*"}]}})",
            "x.kicad_pro", diagnostics);
        QCOMPARE(diagnostics.entries().size(), std::size_t{0});
        QCOMPARE(project.variables.at("BOARD"), std::string("X1"));
        QCOMPARE(project.classOf("A/B"), std::string("Fast"));
        QCOMPARE(project.classOf("A{slash}B"), std::string("Fast"));
        QCOMPARE(project.classOf("C"), std::string("Slow"));
        QCOMPARE(project.classOf("D"), std::string("Default"));
        QCOMPARE(project.classOf("OLD1"), std::string("Old"));
        QCOMPARE(project.classOf("VCC_3V3"), std::string("Power"));
        QCOMPARE(project.classOf("VC"), std::string("Default"));
    }

    void whatIsNoProjectIsReported() {
        for (const char* text : {"", "[]", "{", "{\"text_variables\": 3, \"net_settings\": []} x"}) {
            Diagnostics diagnostics;
            QVERIFY(kicad::readProject(text, "x.kicad_pro", diagnostics).variables.empty());
            QCOMPARE(diagnostics.entries().size(), std::size_t{1});
        }
        Diagnostics diagnostics;
        static_cast<void>(
            kicad::readProject(R"({"text_variables": [1], "net_settings": {"classes": 3}})", "x", diagnostics));
    }
};

QTEST_APPLESS_MAIN(ProjectTest)
#include "project_test.moc"
