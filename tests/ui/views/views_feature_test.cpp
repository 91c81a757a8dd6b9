// Commands of both views.
#include "ui/views/views_feature.h"

#include <QStatusBar>
#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"

using ui::ActionId;

class ViewsFeatureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void zoomingToNothingIsSaid() {
        TestWindow& window = m_fixture->window();
        QVERIFY(window.selection().isEmpty());
        const auto said = [&] { return window.statusBar()->currentMessage(); };
        window.actions()[ActionId::ShowSelection].trigger();
        QVERIFY2(said().startsWith("Nothing is selected"), qPrintable(said()));
        window.workspace().report(QString());
        window.selection().select({{0, model::ElementId{0}}});
        window.actions()[ActionId::ShowSelection].trigger();
        QVERIFY2(!said().startsWith("Nothing is selected"), qPrintable(said()));
    }

private:
    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ViewsFeatureTest)
#include "views_feature_test.moc"
