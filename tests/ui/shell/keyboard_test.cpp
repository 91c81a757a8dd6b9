// The window is used with keys alone, and with keys of other programs.

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPointer>
#include <QSpinBox>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/rule_dialog.h"
#include "ui/common/table_view.h"
#include "ui/element/element_panel.h"
#include "ui/layers/layers_panel.h"
#include "ui/nets/nets_panel.h"
#include "ui/search/search_box.h"

using ui::ActionId;
namespace fs = std::filesystem;

class KeyboardTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        m_job = m_fixture->copyOfJob("everything");
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aBoardIsLookedIntoByKeysAlone() {
        openByKeys();
        find("GND");
        QCOMPARE(window().selection().nets().size(), std::size_t{1});
        find("U1");
        QVERIFY(!window().selection().selected().empty());
        QVERIFY(!window().fact("Side").isEmpty());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().selected().empty());

        walkTo("layers");
        QWidget* layers = QApplication::focusWidget();
        QVERIFY(window().layersPanel().isAncestorOf(layers));
        QTest::keyClick(layers, Qt::Key_Down);
        QTest::keyClick(layers, Qt::Key_Down);
        const model::LayerId chosen = window().layersPanel().currentLayer();
        QVERIFY(chosen.isValid());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_H);
        QCOMPARE(window().layers().soloLayer(), chosen);
        QTest::keyClick(layers, Qt::Key_Escape);
        QTRY_VERIFY(dockWithKeyboard().isEmpty());
        QCOMPARE(window().selection().nets().size(), std::size_t{1});  // Esc only went back to the view

        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        QCOMPARE(window().savedViews().rowCount(), 1);
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window().savedViews().rowCount(), 0);
    }

    void whatTakesTheKeyboardHasANameToReadOut() {
        openByKeys();
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) {
            for (QWidget* widget : dock->widget()->findChildren<QWidget*>()) {
                if ((widget->focusPolicy() & Qt::TabFocus) == 0 || widget->window() != &window()) {
                    continue;  // lists that boxes open are named by them
                }
                QAccessibleInterface* read = QAccessible::queryAccessibleInterface(widget);
                QVERIFY2(read != nullptr && !read->text(QAccessible::Name).isEmpty(),
                         qPrintable(dock->objectName() + ": " + widget->metaObject()->className() + " " +
                                    widget->objectName()));
            }
        }
        const QModelIndex colour = window().layers().index(0, ui::LayerModel::Colour);
        QVERIFY(colour.data(Qt::AccessibleTextRole).toString().startsWith('#'));
    }

    void panelsTakeTurns() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QStringList forth;
        const qsizetype stops = window().findChildren<QDockWidget*>().size() + 2;  // and both views
        for (qsizetype i = 0; i < stops; ++i) {
            step(ActionId::NextPanel);
            forth += dockWithKeyboard();
        }
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) {
            if (!dock->isHidden()) {
                QVERIFY2(forth.contains(dock->objectName()), qPrintable(dock->objectName()));
            }
        }
        step(ActionId::PreviousPanel);
        QCOMPARE(dockWithKeyboard(), forth[forth.size() - 2]);
    }

    void keysThatMoveInATableStayThere() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        walkTo("nets");
        auto* table = window().netsPanel().findChild<ui::TableView*>();
        table->setFocus();
        const glm::vec3 direction = window().views().active().controller().camera().direction();
        QTest::keyClick(table, Qt::Key_PageDown);
        QCOMPARE(table->currentIndex().row(), table->model()->rowCount() - 1);
        QTest::keyClick(table, Qt::Key_PageUp);
        QCOMPARE(table->currentIndex().row(), 0);
        QTest::keyClick(table, Qt::Key_Space);  // turns the board over on the canvas
        QCOMPARE(window().views().active().controller().camera().direction(), direction);
    }

    void keysThatMoveASliderStayThere() {
        openByKeys();
        auto* slider = window().findChild<QSlider*>("heightScale");
        slider->setFocus();
        QTRY_VERIFY(slider->hasFocus());
        const model::LayerId layer = window().workspace().currentLayer();
        const int before = slider->value();
        QTest::keyClick(slider, Qt::Key_PageUp);  // the layer above, on the canvas
        QVERIFY(slider->value() > before);
        QCOMPARE(window().workspace().currentLayer(), layer);
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(slider->value(), slider->minimum());
    }

    void theViewUnderThePointerTakesTheKeyboard() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        ui::BoardView& flat = window().views().flat();
        window().showPanel("layers");
        ui::TableView& layers = window().layersPanel().table();
        QTest::mouseClick(layers.viewport(), Qt::LeftButton, {}, {40, 30});
        layers.setFocus();
        QTRY_VERIFY(layers.hasFocus());
        pointAt(flat);
        QTRY_VERIFY(flat.hasKeyboard());
        const std::vector<bool> visible = window().layers().visibility();
        const float before = flat.controller().camera().direction().z;
        m_fixture->key(Qt::Key_Space);
        QCOMPARE(flat.controller().camera().direction().z, -before);
        QCOMPARE(window().layers().visibility(), visible);
    }

    void escFromTheRulesLeavesTheWindowAsItWas() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        ui::BoardView& solid = window().views().solid();
        pointAt(solid);
        QTRY_VERIFY(solid.hasKeyboard());
        const QDockWidget& panel = *window().findChild<QDockWidget*>("clearances");
        QVERIFY(panel.isHidden());
        m_fixture->key(Qt::Key_R, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY(window().findChild<ui::RuleDialog*>() != nullptr);
        const QPointer<QDialog> dialog = window().findChild<ui::RuleDialog*>();
        QVERIFY(QTest::qWaitForWindowActive(dialog));
        QVERIFY2(panel.isHidden(), "nothing of it was asked for yet");
        QTest::keyClick(dialog.data(), Qt::Key_Escape);
        QTRY_VERIFY(dialog.isNull());
        QVERIFY(panel.isHidden());
        QTRY_VERIFY(solid.hasKeyboard());
        m_fixture->key(Qt::Key_R, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY(window().findChild<ui::RuleDialog*>() != nullptr);
        window().findChild<ui::RuleDialog*>()->accept();
        QVERIFY2(!panel.isHidden(), "there they are seen and checked");
        QTRY_VERIFY(solid.hasKeyboard());
    }

    void whoTypesGoesOnTyping() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        window().showPanel("nets");
        QLineEdit& filter = window().netsPanel().filterEdit();
        filter.setFocus();
        QTRY_VERIFY(filter.hasFocus());
        pointAt(window().views().flat());
        QVERIFY(filter.hasFocus());
        window().showPanel("layers");
        ui::TableView& layers = window().layersPanel().table();
        layers.setFocus();
        layers.edit(layers.model()->index(1, ui::LayerModel::Opacity));  // row 0 is a heading
        QTRY_VERIFY(qobject_cast<QSpinBox*>(QApplication::focusWidget()) != nullptr);
        pointAt(window().views().solid());
        QVERIFY(qobject_cast<QSpinBox*>(QApplication::focusWidget()) != nullptr);
    }

    void presetsAreKeptAndWork() {
        window().actions()[ActionId::KeysKLayout].trigger();
        m_fixture->restart();
        QVERIFY(window().actions()[ActionId::KeysKLayout].isChecked());
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        ui::CameraController& solid = window().views().solid().controller();
        window().views().setActive(window().views().solid());
        const float fitted = solid.mmPerPixel();
        m_fixture->key(Qt::Key_Return);
        QVERIFY(solid.mmPerPixel() < fitted * 0.9F);
        m_fixture->key(Qt::Key_F2);
        QVERIFY(std::abs(solid.mmPerPixel() / fitted - 1.0F) < 1e-3F);
        window().resetSettings();
        QVERIFY(window().actions()[ActionId::KeysCopperscope].isChecked());
        QTest::qWait(50);  // the panels are as they were at first too
        const float fittedAnew = solid.mmPerPixel();
        m_fixture->key(Qt::Key_Return);
        QCOMPARE(solid.mmPerPixel(), fittedAnew);
    }

    void keysMayBeTypedOneAfterTheOther() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        m_fixture->key(Qt::Key_K, Qt::ControlModifier);
        m_fixture->key(Qt::Key_D);
        QVERIFY(window().actions()[ActionId::ThemeDark].isChecked());
        m_fixture->key(Qt::Key_K, Qt::ControlModifier);
        m_fixture->key(Qt::Key_S);
        QVERIFY(window().actions()[ActionId::ThemeSystem].isChecked());
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    /// As the pointer comes from elsewhere.
    static void pointAt(ui::BoardView& view) {
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view.canvas(), &leave);
        const QPointF at(view.width() / 2.0, view.height() / 2.0);
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view.canvas(), &move);
    }

    void openByKeys() {
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        QTest::keyClick(&window(), Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(window().findChild<QFileDialog*>() != nullptr);
        auto* dialog = window().findChild<QFileDialog*>();
        QGuiApplication::clipboard()->setText(QString::fromStdString(m_job.string()));
        QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_V, Qt::ControlModifier);
        QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
        QTRY_VERIFY(window().document() != nullptr);
        window().activateWindow();  // as a window manager does when a dialog goes
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        QTRY_VERIFY(window().views().isVisible());
    }

    void find(const QString& text) {
        m_fixture->key(Qt::Key_F, Qt::ControlModifier);
        auto* line = window().searchBox().findChild<QLineEdit*>();
        QTRY_VERIFY(line->isVisible());
        QTest::keyClicks(line, text);
        QTest::keyClick(line, Qt::Key_Return);
    }

    QString dockWithKeyboard() {
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) {
            if (QApplication::focusWidget() != nullptr && dock->isAncestorOf(QApplication::focusWidget())) {
                return dock->objectName();
            }
        }
        return {};
    }

    /// One panel on; the display needs a moment to move the keyboard between windows.
    void step(ActionId way) {
        window().actions()[way].trigger();
        QTest::qWait(30);
    }

    void walkTo(const QString& dock) {
        window().activateWindow();  // as a desktop does when the search line goes away
        for (int i = 0; i < 20 && dockWithKeyboard() != dock; ++i) {
            step(ActionId::NextPanel);
        }
        QCOMPARE(dockWithKeyboard(), dock);
    }

    std::unique_ptr<WindowFixture> m_fixture;
    fs::path m_job;
};

QTEST_MAIN(KeyboardTest)
#include "keyboard_test.moc"
