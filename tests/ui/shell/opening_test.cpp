#include <QDialogButtonBox>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QTreeWidget>
#include <QUrl>
#include <QtTest>
#include <fstream>

#include "model/session/session.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/paths.h"
#include "ui/shell/change_bar.h"
#include "ui/shell/form_chooser.h"
#include "ui/workspace/board_watch.h"

namespace fs = std::filesystem;
using ui::ActionId;

namespace {

const char* const kImage =
    "%TF.FileFunction,Copper,L1,Top*%\n%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,1*%\nD10*\nX0Y0D03*\nX5000000Y0D03*\nM02*\n";

std::string textOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    const fs::path beside = path.string() + ".new";
    std::ofstream(beside, std::ios::binary) << text;
    fs::rename(beside, path);
}

std::string kicadBoard() {
    return textOf(fs::path(locations::kTestData) / "kicad" / "small.kicad_pcb");
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
        text.replace(at, what.size(), with);
    }
    return text;
}

void drop(QWidget& target, const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &enter);
    QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &event);
}

}  // namespace

/// From files on the disk to the board in the window, and back when they change.
class OpeningTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().find<ui::BoardWatch>().setQuietMs(100);
        m_folder = fs::path(m_fixture->folder().toStdString()) / "boards";
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void enterTakesTheFirstForm() {
        fillWithForms();
        window().open(m_folder);
        QTRY_VERIFY(chooser() != nullptr);
        const auto& list = *chooser()->findChild<QTreeWidget*>();
        QCOMPARE(list.topLevelItemCount(), 3);
        QCOMPARE(list.topLevelItem(0)->text(0), "KiCad board");
        QCOMPARE(list.topLevelItem(0)->text(1), "small.kicad_pcb");
        QCOMPARE(list.topLevelItem(1)->text(0), "ODB++ job");
        QCOMPARE(list.topLevelItem(2)->text(2), "1 image");
        QVERIFY(window().document() == nullptr);
        QTest::keyClick(chooser()->findChild<QTreeWidget*>(), Qt::Key_Return);
        QTRY_VERIFY(window().document() != nullptr);
        QCOMPARE(window().workspace().board()->format, std::string("kicad"));
        QCOMPARE(window().windowTitle(), "small.kicad_pcb – Copperscope");
    }

    void anotherFormIsChosenByTheKeyboard() {
        fillWithForms();
        window().open(m_folder);
        QTRY_VERIFY(chooser() != nullptr);
        QTest::keyClick(chooser()->findChild<QTreeWidget*>(), Qt::Key_Down);
        QTest::keyClick(chooser()->findChild<QTreeWidget*>(), Qt::Key_Return);
        QTRY_VERIFY(window().document() != nullptr);
        QCOMPARE(window().workspace().board()->format, std::string("odb"));
        QCOMPARE(window().windowTitle(), "sync.tgz – Copperscope");
        window().workspace().reload();
        QTRY_VERIFY(!window().loader().isLoading());
        QVERIFY(chooser() == nullptr);
        QCOMPARE(window().workspace().board()->format, std::string("odb"));
    }

    void aChoiceThatIsNotMadeOpensNothing() {
        fillWithForms();
        window().open(m_folder);
        QTRY_VERIFY(chooser() != nullptr);
        QTest::keyClick(chooser(), Qt::Key_Escape);
        QTRY_VERIFY(chooser() == nullptr);
        QVERIFY(!window().loader().isLoading());
        QVERIFY(window().document() == nullptr);
        QVERIFY(!window().messageBar().isVisible());
    }

    void imagesThatAreDroppedTogetherAreOneJob() {
        write(m_folder / "job" / "a.gtl", kImage);
        write(m_folder / "job" / "a.gbl", replaced(kImage, "L1,Top", "L2,Bot"));
        drop(window(), {QUrl::fromLocalFile(ui::fromPath(m_folder / "job" / "a.gtl")),
                        QUrl::fromLocalFile(ui::fromPath(m_folder / "job" / "a.gbl"))});
        QTRY_VERIFY(window().document() != nullptr);
        QCOMPARE(window().windowTitle(), "job – Copperscope");
        const auto& layers = window().document()->layers;
        QCOMPARE(std::ranges::count_if(layers, &model::Layer::isCopper), 2);
    }

    void aBoardOfKicadThatIsSavedIsReadAnewAndTheViewStays() {
        const fs::path board = m_folder / "small.kicad_pcb";
        write(board, kicadBoard());
        QVERIFY(m_fixture->openAndWait(ui::fromPath(board)));
        const model::LayerId bottom = window().document()->findLayer("B.Cu");
        QVERIFY(bottom.isValid());
        const QModelIndex visible = window().layers().index(static_cast<int>(bottom.row()), ui::LayerModel::Visible);
        QVERIFY(window().layers().setData(visible, Qt::Unchecked, Qt::CheckStateRole));
        ui::SelectionModel& selection = window().selection();
        selection.setNets({netNamed("GND")});
        selection.select({elementOn("Top copper")});
        window().views().flat().controller().zoomAtCentre(3.0F);
        window().views().solid().controller().zoomAtCentre(2.0F);
        QTest::qWait(600);  // until the cameras rest
        const model::Box box = boxOfSelected();
        const base::PointD middle = middleOfView();
        const float scale = flatScale();

        // Another name of another net, and an outline that goes further to the left.
        write(board, replaced(replaced(kicadBoard(), "A{slash}B", "CLOCK"), "(start 0 0) (end 30 20)",
                              "(start -4 0) (end 30 20)"));
        const model::Document* before = window().document();
        QTRY_VERIFY(window().document() != before && !window().loader().isLoading());
        QVERIFY(!window().find<ui::ChangeBar>().isVisible());
        QVERIFY(
            std::ranges::any_of(window().document()->nets, [](const model::Net& net) { return net.name == "CLOCK"; }));
        QVERIFY(!window().layers().data(visible, Qt::CheckStateRole).toBool());
        QCOMPARE(selection.nets(), std::vector{netNamed("GND")});
        QCOMPARE(selection.selected().size(), std::size_t(1));
        QVERIFY(boxOfSelected() == box);
        QVERIFY(std::abs(flatScale() / scale - 1.0F) < 1e-4F);
        QVERIFY(std::hypot(middleOfView().x - middle.x, middleOfView().y - middle.y) < 2000.0);
    }

    void otherFormatsAskBeforeTheyAreReadAnew() {
        const fs::path image = m_folder / "top.gtl";
        write(image, kImage);
        QVERIFY(m_fixture->openAndWait(ui::fromPath(image)));
        const model::Document* before = window().document();
        const std::size_t elements = before->elements.size();
        auto& bar = window().find<ui::ChangeBar>();
        QVERIFY(!bar.isVisible());
        write(image, replaced(kImage, "M02*", "X9000000Y0D03*\nM02*"));
        QTRY_VERIFY(bar.isVisible());
        QTest::mouseClick(buttonOf(bar, "&Ignore"), Qt::LeftButton);
        QVERIFY(!bar.isVisible());
        QCOMPARE(window().document(), before);
        write(image, replaced(kImage, "M02*", "X9000000Y0D03*\nX9000000Y5000000D03*\nM02*"));
        QTRY_VERIFY(bar.isVisible());
        QTest::mouseClick(buttonOf(bar, "&Reload"), Qt::LeftButton);
        QTRY_VERIFY(window().document()->elements.size() == elements + 2);
        QVERIFY(!bar.isVisible());
    }

    void aFileThatIsBrokenLeavesTheBoardOnTheScreen() {
        const fs::path board = m_folder / "small.kicad_pcb";
        write(board, kicadBoard());
        QVERIFY(m_fixture->openAndWait(ui::fromPath(board)));
        const model::Document* before = window().document();
        write(board, "this is no board any more");
        QTRY_VERIFY(window().messageBar().isVisible());
        QCOMPARE(window().document(), before);
        write(board, kicadBoard());
        QTRY_VERIFY(window().document() != before);
        QVERIFY(!window().messageBar().isVisible());
    }

private:
    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] ui::FormChooser* chooser() { return window().findChild<ui::FormChooser*>(); }
    void fillWithForms() const {
        fs::create_directories(m_folder);
        fs::copy_file(locations::kSample, m_folder / "sync.tgz");
        write(m_folder / "small.kicad_pcb", kicadBoard());
        write(m_folder / "gerbers" / "a.gtl", kImage);
    }
    [[nodiscard]] static QPushButton* buttonOf(const QWidget& bar, const QString& text) {
        for (auto* button : bar.findChildren<QPushButton*>()) {
            if (button->text() == text) {
                return button;
            }
        }
        qFatal("no button %s", qPrintable(text));
    }
    [[nodiscard]] model::BoardNet netNamed(const std::string& name) {
        const auto& nets = window().document()->nets;
        for (std::size_t row = 0; row < nets.size(); ++row) {
            if (nets[row].name == name) {
                return {0, model::NetId{row}};
            }
        }
        qFatal("no such net");
    }
    [[nodiscard]] model::BoardElement elementOn(const std::string& layer) {
        const model::Document& board = *window().document();
        for (std::size_t row = 0; row < board.elements.size(); ++row) {
            if (board.elements.layer[row] == board.findLayer(layer)) {
                return {0, model::ElementId{row}};
            }
        }
        qFatal("no such element");
    }
    [[nodiscard]] model::Box boxOfSelected() {
        return window().document()->boxOf(window().selection().selected().front().element);
    }
    [[nodiscard]] base::PointD middleOfView() {
        const QSizeF size = window().views().flat().controller().viewport();
        return window().views().flat().locationAt({size.width() / 2.0, size.height() / 2.0});
    }
    [[nodiscard]] float flatScale() { return window().views().flat().controller().camera().mmPerPixel(100.0F); }

    std::unique_ptr<WindowFixture> m_fixture;
    fs::path m_folder;
};

QTEST_MAIN(OpeningTest)
#include "opening_test.moc"
