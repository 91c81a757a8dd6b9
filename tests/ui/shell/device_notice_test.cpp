#include "ui/shell/device_notice.h"

#include <QLabel>
#include <QPushButton>
#include <QStatusBar>
#include <QtTest>

#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

namespace {

render::gpu::Caps device(const char* name, bool isCpu) {
    render::gpu::Caps caps;
    caps.name = name;
    caps.isCpu = isCpu;
    return caps;
}

}  // namespace

class DeviceNoticeTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_fixture = std::make_unique<WindowFixture>(); }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aSoftwareDeviceIsSaidOnceInPlainWords() {
        ui::Settings& settings = m_fixture->settings();
        settings.reset();
        QWidget parent;
        const ui::DeviceNotice first(device("llvmpipe", true), settings, &parent);
        const ui::DeviceNotice second(device("llvmpipe", true), settings, &parent);
        parent.show();
        QVERIFY(first.isVisible() && !second.isVisible());
        const QString text = first.findChild<QLabel*>("softwareDevice")->text();
        QVERIFY(text.startsWith("No graphics card is in use") && text.contains("llvmpipe") && text.contains("driver"));
        QTest::mouseClick(first.findChild<QPushButton*>(), Qt::LeftButton);
        QVERIFY(!first.isVisible());
    }

    void aGraphicsCardIsNot() {
        m_fixture->settings().reset();
        QWidget parent;
        const ui::DeviceNotice notice(device("A card", false), m_fixture->settings(), &parent);
        parent.show();
        QVERIFY(!notice.isVisible());
        QVERIFY(!m_fixture->settings().knowsOfSoftwareDevice());
    }

    void theWindowHasItInItsFirstRun() {
        const bool isCpu = m_fixture->context().device().caps().isCpu;
        QVERIFY(!window().find<ui::DeviceNotice>().isVisible());
        m_fixture->settings().reset();
        m_fixture->restart();
        QCOMPARE(window().find<ui::DeviceNotice>().isVisible(), isCpu);
        m_fixture->restart();
        QVERIFY(!window().find<ui::DeviceNotice>().isVisible());
    }

    void theStatusBarGoesOnSayingSo() {
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        QTRY_VERIFY(window().label("frame").endsWith(" ms"));
        const render::gpu::Caps& caps = m_fixture->context().device().caps();
        QCOMPARE(window().label("frame").startsWith("no graphics card · "), caps.isCpu);
        QVERIFY(window().findChild<QLabel*>("frame")->toolTip().startsWith(QString::fromStdString(caps.name)));
    }

    void aMessageThatIsCutIsWholeInItsToolTip() {
        const QString message(500, u'm');
        window().statusBar()->showMessage(message);
        QCOMPARE(window().statusBar()->toolTip(), message);
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(DeviceNoticeTest)
#include "device_notice_test.moc"
