#include "ui/views/view_history.h"

#include <QtTest>

using ui::CameraController;
using ui::ViewHistory;

class ViewHistoryTest : public QObject {
    Q_OBJECT

private slots:
    void backAndForwardKeepTheProjectionOfNow() {
        CameraController camera;
        camera.setViewport({800.0, 600.0});
        camera.setBox({-50.0F, -40.0F, 0.0F}, {50.0F, 40.0F, 1.6F});
        camera.look(render::NamedView::Iso);
        ViewHistory history(camera);
        history.clear();
        rest();
        render::CameraPose first = camera.camera().pose();
        camera.orbit({100.0, 0.0});
        rest();
        render::CameraPose second = camera.camera().pose();
        QVERIFY(first.yaw != second.yaw);
        camera.setOrthographic(true);
        rest();  // the same place
        history.back();
        first.isOrthographic = true;
        QVERIFY(camera.camera().pose() == first);
        camera.setOrthographic(false);
        history.forward();
        QVERIFY(camera.camera().pose() == second);
        camera.setOrthographic(true);
        history.forward();  // there is nothing ahead
        second.isOrthographic = true;
        QVERIFY(camera.camera().pose() == second);
    }

private:
    static void rest() { QTest::qWait(ViewHistory::kRestMs + 100); }
};

QTEST_GUILESS_MAIN(ViewHistoryTest)
#include "view_history_test.moc"
