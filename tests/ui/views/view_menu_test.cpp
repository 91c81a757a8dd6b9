// What the menu of a right click in a view does.

#include <QMenu>
#include <QMouseEvent>
#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"

using ui::BoardView;

class ViewMenuTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void onlyTheLayerOfAnElementIsShownOnceAndAgain() {
        const model::ElementId pad = aPad();
        QVERIFY(pad.isValid());
        const model::LayerId layer = board().elements.layer[pad.row()];
        window().layers().showCopperOnly();  // a hole in the pad would lie on top
        window().layers().toggleSolo(layer);
        chooseAt(pad, "Only layer ");
        QCOMPARE(window().layers().soloLayer(), layer);
        window().layers().toggleSolo(layer);
        chooseAt(pad, "Only layer ");  // of what lies on top there
        QVERIFY(window().layers().soloLayer().isValid());
        QCOMPARE(window().layers().soloLayer(), window().workspace().currentLayer());
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    const model::Document& board() { return *window().document(); }

    /// A round one with a net on the uppermost copper.
    model::ElementId aPad() {
        const auto& elements = board().elements;
        for (std::size_t row = 0; row < elements.size(); ++row) {
            const model::Layer& layer = board().layer(elements.layer[row]);
            if (layer.isCopper() && layer.side == model::LayerSide::Top && (elements.flags[row] & model::kPad) != 0 &&
                elements.kind[row] == model::ElementKind::Circle && elements.net[row].isValid()) {
                return model::ElementId{row};
            }
        }
        return {};
    }

    /// What begins like this in the menu of a right click on a pad.
    void chooseAt(model::ElementId pad, const QString& text) {
        BoardView& view = window().views().flat();
        const model::Layer& layer = board().layer(board().elements.layer[pad.row()]);
        const model::Box box = board().boxOf(pad);
        const ui::BoardPosition position = window().probing().position();
        const glm::vec3 low = position.toModel(base::toDouble(box.min));
        const glm::vec3 high = position.toModel(base::toDouble(box.max));
        view.controller().show(low, high);
        glm::vec3 centre = (low + high) / 2.0F;
        centre.z = static_cast<float>(base::toMm(layer.z + layer.thickness));
        const QPointF at = view.controller().screenOf(centre).value_or(QPointF(-1, -1));
        mouse(view, QEvent::MouseButtonPress, at);
        mouse(view, QEvent::MouseButtonRelease, at);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu != nullptr);
        const QList<QAction*> actions = menu->actions();
        const auto found =
            std::ranges::find_if(actions, [&](const QAction* action) { return action->text().startsWith(text); });
        QVERIFY(found != actions.end());
        (*found)->trigger();
        menu->close();
        window().activateWindow();  // the offscreen platform does not give it back
        (void)QTest::qWaitForWindowActive(&window());
    }
    static void mouse(BoardView& view, QEvent::Type type, QPointF at) {
        const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::RightButton;
        QMouseEvent event(type, at, view.mapToGlobal(at), Qt::RightButton, held, Qt::NoModifier);
        QCoreApplication::sendEvent(&view.canvas(), &event);
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ViewMenuTest)
#include "view_menu_test.moc"
