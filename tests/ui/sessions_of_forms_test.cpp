#include <QProcess>
#include <QtTest>
#include <fstream>

#include "model/session/session.h"
#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/rule_model.h"
#include "ui/common/paths.h"
#include "ui/nets/net_styles.h"

namespace fs = std::filesystem;
using ui::ActionId;

namespace {

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

void writeGerberJob(const fs::path& folder) {
    const std::string image =
        "%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,1*%\nD10*\n%TO.N,GND*%\nX0Y0D03*\nX5000000Y3000000D03*\nM02*\n";
    for (const char* name : {"board.gtl", "board.gbl", "board.gts"}) {
        write(folder / name, image);
    }
    write(folder / "board.gko",
          "%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,0.1*%\nD10*\nX-2000000Y-2000000D02*\n"
          "X8000000Y-2000000D01*\nX8000000Y5000000D01*\nX-2000000Y5000000D01*\n"
          "X-2000000Y-2000000D01*\nM02*\n");
}

bool run(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    return process.waitForFinished(30000) && process.exitCode() == 0;
}

/// Makes the board of this form in the folder; its path.
fs::path makeForm(const WindowFixture& fixture, const QString& form, const fs::path& folder) {
    fs::create_directories(folder);
    const fs::path ipc = fs::path(locations::kFuzzCorpus) / "ipc2581" / "board_c.xml";
    const fs::path kicad = fs::path(locations::kTestData) / "kicad" / "small.kicad_pcb";
    if (form == "ODB++ archive") {
        return ui::toPath(fixture.copyOfSample());
    }
    if (form == "ODB++ folder") {
        return fixture.copyOfJob("everything");
    }
    if (form.startsWith("IPC-2581")) {
        fs::copy_file(ipc, folder / "board.xml");
        const bool isPacked = form.endsWith("packed") && run("gzip", {ui::fromPath(folder / "board.xml")});
        return folder / (isPacked ? "board.xml.gz" : "board.xml");
    }
    if (form == "KiCad") {
        fs::copy_file(kicad, folder / "small.kicad_pcb");
        return folder / "small.kicad_pcb";
    }
    writeGerberJob(folder / "job");
    if (form == "Gerber image") {
        return folder / "job" / "board.gtl";
    }
    const bool isPacked = form == "Gerber archive" && run("tar", {"-czf", ui::fromPath(folder / "job.tgz"), "-C",
                                                                  ui::fromPath(folder / "job"), "."});
    return folder / (isPacked ? "job.tgz" : "job");
}

}  // namespace

/// What a user sets for a board is there again when it is opened, whatever the board is written in.
class SessionsOfFormsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_fixture = std::make_unique<WindowFixture>(); }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void allThatWasSetIsThereAgain_data() {
        QTest::addColumn<QString>("ending");
        QTest::newRow("ODB++ archive") << ".tgz";
        QTest::newRow("ODB++ folder") << "everything";
        QTest::newRow("IPC-2581") << ".xml";
        QTest::newRow("IPC-2581 packed") << ".xml.gz";
        QTest::newRow("KiCad") << ".kicad_pcb";
        QTest::newRow("Gerber folder") << "job";
        QTest::newRow("Gerber archive") << "job.tgz";
        QTest::newRow("Gerber image") << ".gtl";
    }
    void allThatWasSetIsThereAgain() {
        QFETCH(QString, ending);
        const fs::path folder = fs::path(m_fixture->folder().toStdString()) / "forms";
        const fs::path path = makeForm(*m_fixture, QTest::currentDataTag(), folder);
        QVERIFY2(ui::fromPath(path).endsWith(ending), path.c_str());
        QVERIFY(m_fixture->openAndWait(ui::fromPath(path)));
        const QString told = shownError();  // of the job itself
        const model::BoardElement element = anElement();
        const model::Box box = window().document()->boxOf(element.element);
        const std::string layer = window().document()->layer(layerOf(element)).name;
        const bool hasNets = !window().document()->nets.empty();

        // What is shown.
        window().workspace().setUnit(ui::LengthUnit::Mil);
        window().views().flat().controller().zoomAtCentre(3.0F);
        window().views().solid().controller().zoomAtCentre(2.0F);
        window().layers().showOnly({layer});
        window().layers().setData(
            window().layers().index(static_cast<int>(layerOf(element).row()), ui::LayerModel::Colour),
            QColor(10, 20, 30), Qt::EditRole);
        const render::CameraPose flat = window().views().flat().controller().camera().pose();
        const render::CameraPose solid = window().views().solid().controller().camera().pose();
        m_fixture->key(Qt::Key_S, Qt::ControlModifier);
        // What was selected, a rule, the colour of a net.
        window().selection().select({element});
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        setRule("7 um");
        if (hasNets) {
            window().selection().setNets({{0, model::NetId{0U}}});
            window().actions()[ActionId::ColourNet].trigger();
            QVERIFY(window().netStyles().of({0, model::NetId{0U}}).colour.has_value());
        }
        const model::RuleTable rules = window().find<ui::RuleModel>().rules();
        window().awaitFiles();
        QVERIFY(fs::exists(model::session::sessionPath(path)));

        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(ui::fromPath(path)));
        QCOMPARE(shownError(), told);
        QCOMPARE(window().workspace().unit(), ui::LengthUnit::Mil);
        QVERIFY(isNear(window().views().flat().controller().camera().pose(), flat));
        QVERIFY(isNear(window().views().solid().controller().camera().pose(), solid));
        QCOMPARE(window().layers().visibleNames(), std::vector<std::string>{layer});
        const model::LayerId again = window().document()->findLayer(layer);
        QCOMPARE(window()
                     .layers()
                     .index(static_cast<int>(again.row()), ui::LayerModel::Colour)
                     .data(Qt::EditRole)
                     .value<QColor>(),
                 QColor(10, 20, 30));
        QVERIFY(window().find<ui::RuleModel>().rules() == rules);
        if (hasNets) {
            QVERIFY(window().netStyles().of({0, model::NetId{0U}}).colour.has_value());
        }
        QCOMPARE(window().savedViews().rowCount(), 1);
        while (window().selection().clearStep()) {
        }
        window().showPanel("views");
        window().table("views").choose(window().table("views").model()->index(0, 0));
        QCOMPARE(window().selection().selected().size(), std::size_t(1));
        QVERIFY(window().document()->boxOf(window().selection().selected().front().element) == box);
    }

private:
    [[nodiscard]] QString shownError() { return window().messageBar().isVisible() ? window().error() : QString(); }
    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] model::LayerId layerOf(const model::BoardElement& element) {
        return window().document()->elements.layer[element.element.row()];
    }
    /// One on outer copper that only one element of its size and place can be.
    [[nodiscard]] model::BoardElement anElement() {
        const model::Document& board = *window().document();
        for (std::uint32_t row = 0; row < board.elements.size(); ++row) {
            if (board.layer(board.elements.layer[row]).isCopper()) {
                return {0, model::ElementId{row}};
            }
        }
        qFatal("no copper");
    }
    void setRule(const QString& least) {
        auto& rules = window().find<ui::RuleModel>();
        const model::RuleTable before = rules.rules();
        QVERIFY(rules.setData(rules.index(0, ui::RuleModel::Least), least, Qt::EditRole));
        QVERIFY(rules.rules() != before);
    }
    static bool isNear(const render::CameraPose& a, const render::CameraPose& b) {
        return std::abs(a.distance - b.distance) < 1e-3F * std::abs(b.distance) + 1e-6F &&
               glm::length(a.target - b.target) < 1e-3F * std::max(1.0F, std::abs(b.distance));
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(SessionsOfFormsTest)
#include "sessions_of_forms_test.moc"
