// How names of layers are cut: what tells two of them apart stays.
#include "ui/layers/layer_name_delegate.h"

#include <QApplication>
#include <QtTest>

using ui::shortName;

class LayerNameDelegateTest : public QObject {
    Q_OBJECT

private slots:
    void namesThatFitAreWhole() { QCOMPARE(shortName("TOP", kNames, letters(), 200), "TOP"); }

    void namesLoseTheirMiddle() {
        const QString name = "SOLDERMASK-BOTTOM";
        const QString cut = shortName(name, kNames, letters(), letters().horizontalAdvance("SOLDER…BOTTOM") + 1);
        QVERIFY2(cut.startsWith("SOLD") && cut.endsWith("TOM") && cut != name, qPrintable(cut));
    }

    void namesThatWouldReadAlikeAreCutWhereTheyDiffer() {
        const int width = letters().horizontalAdvance("SOLDER…r mask") + 1;
        const QString top = shortName("SOLDERMASK-TOP solder mask", kNames, letters(), width);
        const QString bottom = shortName("SOLDERMASK-BOTTOM solder mask", kNames, letters(), width);
        QVERIFY2(top.startsWith("…TOP"), qPrintable(top));
        QVERIFY2(bottom.startsWith("…BOTTOM"), qPrintable(bottom));
        QVERIFY(letters().horizontalAdvance(top) <= width && letters().horizontalAdvance(bottom) <= width);
    }

    void aNameThatAnotherBeginsWithKeepsItsEnd() {
        const QStringList names = {"bottom solder mask", "bottom solder mask solder mask"};
        const int width = letters().horizontalAdvance("…om solder mask") + 1;
        QVERIFY(letters().horizontalAdvance(names[0]) > width);
        const QString mask = shortName(names[0], names, letters(), width);
        const QString film = shortName(names[1], names, letters(), width);
        QVERIFY2(mask.startsWith("…") && mask.endsWith("m solder mask"), qPrintable(mask));
        QVERIFY2(film.startsWith("…") && film.endsWith(" solder mask") && film != mask, qPrintable(film));
    }

private:
    static QFontMetrics letters() { return QFontMetrics(QApplication::font()); }

    const QStringList kNames = {"TOP", "SOLDERMASK-TOP", "SOLDERMASK-BOTTOM", "SOLDERMASK-TOP solder mask",
                                "SOLDERMASK-BOTTOM solder mask"};
};

QTEST_MAIN(LayerNameDelegateTest)
#include "layer_name_delegate_test.moc"
