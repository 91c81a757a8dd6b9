#include "ui/shell/status_bar.h"

#include <QLabel>
#include <QtTest>

class StatusBarTest : public QObject {
    Q_OBJECT

private slots:
    void messagesWithoutRoomEndWithAnEllipsis() {
        ui::StatusBar bar;
        auto* permanent = new QLabel(QStringLiteral("no graphics card"));
        bar.addPermanentWidget(permanent);
        bar.resize(1500, 30);
        bar.show();
        const QString message = QStringLiteral("All rules pass: 1,234 clearances, 56 widths, 78 annular rings");
        bar.showMessage(message);
        QTRY_VERIFY(permanent->x() > 1000);
        QCOMPARE(bar.shownMessage(), message);
        bar.resize(300, 30);
        QTRY_VERIFY(permanent->x() < 300);
        QVERIFY2(bar.shownMessage().endsWith(QChar(0x2026)), qPrintable(bar.shownMessage()));
        QVERIFY(message.startsWith(bar.shownMessage().chopped(1)));
        QVERIFY(bar.fontMetrics().horizontalAdvance(bar.shownMessage()) < permanent->x());
        QCOMPARE(bar.currentMessage(), message);
    }
};

QTEST_MAIN(StatusBarTest)
#include "status_bar_test.moc"
