#include "ui/canvas/device_turns.h"

#include <QtTest>

using ui::DeviceTurns;

class DeviceTurnsTest : public QObject {
    Q_OBJECT

    QObject a, b, c;

private slots:
    void oneAfterTheOtherInTheOrderTheyAsked() {
        DeviceTurns turns;
        QList<QObject*> came;
        connect(&turns, &DeviceTurns::came, this, [&](QObject* user) { came.push_back(user); });
        QVERIFY(turns.begin(a));
        QVERIFY(turns.begin(a));
        QVERIFY(!turns.begin(b));
        QVERIFY(!turns.begin(c));
        QVERIFY(!turns.begin(b));
        turns.end(a);
        QVERIFY2(came.isEmpty(), "a turn comes from the event loop");
        QCoreApplication::processEvents();
        QCOMPARE(came, QList<QObject*>{&b});
        QVERIFY2(turns.begin(b) && !turns.begin(a) && !turns.begin(c), "it is b's, until it ends");
        turns.end(b);
        QCoreApplication::processEvents();
        QCOMPARE(came, (QList<QObject*>{&b, &c}));
        turns.end(c);
        QCoreApplication::processEvents();
        QCOMPARE(came, (QList<QObject*>{&b, &c, &a}));
        QVERIFY(!turns.isFree());
        turns.end(a);
        QVERIFY(turns.isFree());
    }

    void whoNoLongerWantsATurnGetsNone() {
        DeviceTurns turns;
        QSignalSpy came(&turns, &DeviceTurns::came);
        QVERIFY(turns.begin(a));
        QVERIFY(!turns.begin(b));
        turns.end(b);
        turns.end(a);
        QCoreApplication::processEvents();
        QCOMPARE(came.size(), 0);
        QVERIFY(turns.begin(c));
    }

    void whoEndsBeforeItIsToldIsNotTold() {
        DeviceTurns turns;
        QList<QObject*> came;
        connect(&turns, &DeviceTurns::came, this, [&](QObject* user) { came.push_back(user); });
        QVERIFY(turns.begin(a));
        QVERIFY(!turns.begin(b));
        QVERIFY(!turns.begin(c));
        turns.end(a);
        turns.end(b);
        QCoreApplication::processEvents();
        QCOMPARE(came, QList<QObject*>{&c});
        turns.end(c);
        QVERIFY(turns.isFree());
    }

    void whoAsksBeforeItIsToldHasItsTurnAndIsNotTold() {
        DeviceTurns turns;
        QSignalSpy came(&turns, &DeviceTurns::came);
        QVERIFY(turns.begin(a));
        QVERIFY(!turns.begin(b));
        turns.end(a);
        QVERIFY(turns.begin(b));
        QCoreApplication::processEvents();
        QCOMPARE(came.size(), 0);
    }

    void whoIsToldMayEndAtOnce() {
        DeviceTurns turns;
        connect(&turns, &DeviceTurns::came, this, [&](QObject* user) { turns.end(*user); });
        QVERIFY(turns.begin(a));
        QVERIFY(!turns.begin(b));
        QVERIFY(!turns.begin(c));
        turns.end(a);
        QTRY_VERIFY(turns.isFree());
        QVERIFY(turns.begin(a));
    }
};

QTEST_GUILESS_MAIN(DeviceTurnsTest)
#include "device_turns_test.moc"
