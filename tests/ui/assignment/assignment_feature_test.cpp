#include <QAbstractItemView>
#include <QComboBox>
#include <QPushButton>
#include <QStatusBar>
#include <QtTest>
#include <fstream>

#include "model/formats/gerber/layer_map.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/assignment/assignment_dialog.h"
#include "ui/common/paths.h"
#include "ui/shell/change_bar.h"
#include "ui/workspace/board_watch.h"

namespace fs = std::filesystem;
using ui::ActionId;
using ui::AssignmentModel;

namespace {

/// An image that says nothing of its layer, with pads of this size.
std::string image(const std::string& size) {
    return "%FSLAX46Y46*%\n%MOMM*%\n%ADD10C," + size + "*%\nD10*\nX0Y0D03*\nX5000000Y3000000D03*\nM02*\n";
}

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

std::string textOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

/// Files of Gerber jobs that nothing tells the layer of: asked for, told by keys, remembered, told otherwise.
class AssignmentFeatureTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().find<ui::BoardWatch>().setQuietMs(100);
        m_job = fs::path(m_fixture->folder().toStdString()) / "job";
        m_map = fs::path(m_fixture->folder().toStdString()) / "job.layers.txt";
    }
    void cleanup() {
        fs::permissions(m_job.parent_path(), fs::perms::owner_all);
        QCOMPARE(validationErrorsOnClosing(m_fixture), 0U);
    }

    void filesThatNothingTellsOfAreAskedForAndTheAnswerIsRemembered() {
        openUnknown();
        QTRY_VERIFY(dialog() != nullptr);
        ui::TableView& table = files();
        QVERIFY(table.hasFocus());
        QCOMPARE(textAt(0, AssignmentModel::File), "plot1.gbr");
        QCOMPARE(textAt(0, AssignmentModel::Draws), "Not known");
        QCOMPARE(table.currentIndex(), table.model()->index(0, AssignmentModel::Draws));
        QVERIFY(table.isColumnHidden(AssignmentModel::Board));
        QVERIFY(dialog()->width() <= 1280 && dialog()->height() <= 800);

        choose("Cop");
        QCOMPARE(textAt(0, AssignmentModel::Draws), "Copper");
        QCOMPARE(textAt(0, AssignmentModel::Number), "2");  // below the one that is known
        QCOMPARE(textAt(0, AssignmentModel::Side), "Bottom");
        QTest::keyClick(&table, Qt::Key_Down);
        choose("Solder m");
        QCOMPARE(textAt(1, AssignmentModel::Draws), "Solder mask");
        QCOMPARE(textAt(1, AssignmentModel::Side), "Top");

        window().selection().select({onlyElementOn("board.gtl")});
        const model::Box box = boxOfSelected();
        window().views().flat().controller().zoomAtCentre(3.0F);
        QTest::qWait(600);  // until the camera rests
        const float scale = flatScale();
        window().layers().showOnly({layerOf("board.gtl")->name, layerOf("plot2.gbr")->name});
        const model::Document* before = window().document();
        QTest::keyClick(&table, Qt::Key_Return, Qt::ControlModifier);
        QTRY_VERIFY(window().document() != before && !window().loader().isLoading());
        QTRY_VERIFY(dialog() == nullptr);

        const model::Layer* copper = layerOf("plot1.gbr");
        QVERIFY(copper != nullptr && copper->isCopper());
        QCOMPARE(layerOf("plot2.gbr")->type, model::LayerType::SolderMask);
        QCOMPARE(window().selection().selected().size(), std::size_t(1));
        QVERIFY(boxOfSelected() == box);
        const std::vector<std::string> visible = window().layers().visibleNames();
        QVERIFY(std::ranges::count(visible, layerOf("plot1.gbr")->name) == 0);
        QVERIFY(std::ranges::count(visible, layerOf("board.gtl")->name) == 1);
        QVERIFY(std::ranges::count(visible, layerOf("plot2.gbr")->name) == 1);
        QVERIFY(std::abs(flatScale() / scale - 1.0F) < 1e-4F);
        QVERIFY(textOf(m_map).find("plot1.gbr = copper bottom 2\n") != std::string::npos);

        // Another window reads it so, asks nothing, and does not take its own file for a change.
        m_fixture->restart();
        window().find<ui::BoardWatch>().setQuietMs(100);
        QVERIFY(m_fixture->openAndWait(ui::fromPath(m_job)));
        QTest::qWait(500);
        QVERIFY(dialog() == nullptr);
        QVERIFY(!window().find<ui::ChangeBar>().isVisible());
        QVERIFY(layerOf("plot1.gbr")->isCopper());
    }

    void whatWasToldIsToldOtherwiseAndTakenBack() {
        openUnknown();
        QTRY_VERIFY(dialog() != nullptr);
        choose("Cop");
        accept();
        QVERIFY(layerOf("plot1.gbr")->isCopper());

        window().actions()[ActionId::AssignLayers].trigger();
        QTRY_VERIFY(dialog() != nullptr);
        const int row = rowOf("plot1.gbr");
        QCOMPARE(textAt(row, AssignmentModel::Draws), "Copper");
        QCOMPARE(textAt(row, AssignmentModel::KnownBy), "the layer map");
        QTest::mouseClick(button("As &found"), Qt::LeftButton);
        QCOMPARE(textAt(rowOf("plot1.gbr"), AssignmentModel::Draws), "Not known");
        accept();
        QVERIFY(!layerOf("plot1.gbr")->isCopper());
    }

    void cancelledItChangesNothingAndAsksNoMore() {
        openUnknown();
        QTRY_VERIFY(dialog() != nullptr);
        choose("Cop");
        const model::Document* before = window().document();
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QTRY_VERIFY(dialog() == nullptr);
        QCOMPARE(window().document(), before);
        QVERIFY(!fs::exists(m_map));
        window().workspace().reload();
        QTRY_VERIFY(window().document() != before && !window().loader().isLoading());
        QTest::qWait(500);
        QVERIFY(dialog() == nullptr);
    }

    void aJobThatTellsAllIsNotAskedFor() {
        write(m_job / "board.gtl", image("1"));
        write(m_job / "board.gbl", image("1"));
        QVERIFY(m_fixture->openAndWait(ui::fromPath(m_job)));
        QTest::qWait(500);
        QVERIFY(dialog() == nullptr);
        window().actions()[ActionId::AssignLayers].trigger();
        QTRY_VERIFY(dialog() != nullptr);
        QCOMPARE(files().model()->rowCount(), 2);
    }

    /// The system refuses to look for a file of such a name.
    void aNameTooLongForAMapBesideItHasNone() {
        m_job = m_job.parent_path() / std::string(250, 'j');
        write(m_job / "board.gtl", image("1"));
        QVERIFY(m_fixture->openAndWait(ui::fromPath(m_job)));
        window().actions()[ActionId::AssignLayers].trigger();
        QTRY_VERIFY(dialog() != nullptr);
        QCOMPARE(files().model()->rowCount(), 1);
    }

    void aBoardThatIsNoGerberJobSaysSo() {
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        window().actions()[ActionId::AssignLayers].trigger();
        QVERIFY(window().statusBar()->currentMessage().contains("Only Gerber jobs"));
        QVERIFY(dialog() == nullptr);
    }

    void nothingIsLeftOutAltogether() {
        write(m_job / "board.gtl", image("1"));
        QVERIFY(m_fixture->openAndWait(ui::fromPath(m_job)));
        window().actions()[ActionId::AssignLayers].trigger();
        QTRY_VERIFY(dialog() != nullptr);
        choose("Left");
        QCOMPARE(textAt(0, AssignmentModel::Draws), "Left out");
        QVERIFY(!button("OK")->isEnabled());
    }

    void whereNothingCanBeWrittenItHoldsForTheWindow() {
        openUnknown();
        QTRY_VERIFY(dialog() != nullptr);
        choose("Cop");
        fs::create_directory(m_map);  // a folder of that name cannot be written over, whoever runs this
        accept();
        QVERIFY(layerOf("plot1.gbr")->isCopper());
        QVERIFY(window().messageBar().isVisible());
        QVERIFY2(window().error().contains("until the window is closed"), qPrintable(window().error()));
    }

private:
    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] ui::AssignmentDialog* dialog() { return window().findChild<ui::AssignmentDialog*>(); }
    [[nodiscard]] ui::TableView& files() { return *dialog()->findChild<ui::TableView*>(); }
    [[nodiscard]] QString textAt(int row, int column) { return files().model()->index(row, column).data().toString(); }
    [[nodiscard]] int rowOf(const QString& file) {
        int row = 0;
        while (row < files().model()->rowCount() && textAt(row, AssignmentModel::File) != file) {
            ++row;
        }
        return row;
    }
    [[nodiscard]] QPushButton* button(const QString& text) {
        for (auto* button : dialog()->findChildren<QPushButton*>()) {
            if (button->text().remove('&') == QString(text).remove('&')) {
                return button;
            }
        }
        qFatal("no button %s", qPrintable(text));
    }
    /// Opens the list of the current cell, types, and takes what that finds.
    void choose(const QString& text) {
        QTest::keyClick(&files(), Qt::Key_Return);
        auto* box = files().findChild<QComboBox*>();
        QVERIFY(box != nullptr);
        QTRY_VERIFY(box->view()->isVisible());
        QTest::keyClicks(box->view(), text);
        QTest::keyClick(box->view(), Qt::Key_Return);
        QTRY_VERIFY(files().findChild<QComboBox*>() == nullptr);
    }
    void accept() {
        const model::Document* before = window().document();
        QTest::mouseClick(button("OK"), Qt::LeftButton);
        QTRY_VERIFY(window().document() != before && !window().loader().isLoading());
        QTRY_VERIFY(dialog() == nullptr);
    }
    /// A job of three files, of which one is named as CAD systems do.
    void openUnknown() {
        write(m_job / "board.gtl", image("1"));
        write(m_job / "plot1.gbr", image("1.1"));
        write(m_job / "plot2.gbr", image("1.2"));
        QVERIFY(m_fixture->openAndWait(ui::fromPath(m_job)));
    }
    [[nodiscard]] const model::Layer* layerOf(const std::string& file) {
        for (const model::Layer& layer : window().document()->layers) {
            if (layer.file == file) {
                return &layer;
            }
        }
        return nullptr;
    }
    [[nodiscard]] model::BoardElement onlyElementOn(const std::string& file) {
        return {0, model::ElementId{layerOf(file)->elements.first}};
    }
    [[nodiscard]] model::Box boxOfSelected() {
        return window().document()->boxOf(window().selection().selected().front().element);
    }
    [[nodiscard]] float flatScale() { return window().views().flat().controller().camera().mmPerPixel(100.0F); }

    std::unique_ptr<WindowFixture> m_fixture;
    fs::path m_job;
    fs::path m_map;
};

QTEST_MAIN(AssignmentFeatureTest)
#include "assignment_feature_test.moc"
