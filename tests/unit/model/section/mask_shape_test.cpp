// Solder mask over copper, and ink on it, worked out by hand.
#include "model/section/mask_shape.h"

#include <QtTest>

using namespace model;

namespace {

/// Copper of 35 µm under a mask of 25 µm, from the side of the board that is named.
BoardFace face(bool isTop, bool isFlat = false) {
    BoardFace face;
    face.isTop = isTop;
    face.isFlat = isFlat;
    face.mask = 25'000;
    face.substrate = isTop ? 1'000'000 : 0;
    face.copper = isTop ? 1'035'000 : -35'000;
    return face;
}

SectionPiece drawn(double from, double to, Nm thickness = 25'000) {
    SectionPiece piece;
    piece.from = from;
    piece.to = to;
    piece.bottom = 1'035'000;
    piece.top = piece.bottom + thickness;
    return piece;
}

/// "lower edge/upper edge@heights" in micrometres.
QStringList textOf(const std::vector<SectionPiece>& pieces) {
    QStringList list;
    for (const SectionPiece& piece : pieces) {
        list << QString("%1-%2/%3-%4@%5-%6")
                    .arg(piece.from / 1000)
                    .arg(piece.to / 1000)
                    .arg(piece.upperFrom() / 1000)
                    .arg(piece.upperTo() / 1000)
                    .arg(piece.bottom / 1000.0)
                    .arg(piece.top / 1000.0);
    }
    return list;
}

}  // namespace

class MaskShapeTest : public QObject {
    Q_OBJECT

private slots:
    void itIsThinOnCopperAndFallsInShouldersBesideIt() {
        QCOMPARE(textOf(maskOver(face(true), drawn(0, 1e6), {{400e3, 600e3}})),
                 (QStringList{"400-600/400-600@1035-1047.5", "0-400/0-400@1000-1025", "375-400/400-400@1025-1047.5",
                              "600-1000/600-1000@1000-1025", "600-625/600-600@1025-1047.5"}));
    }

    void theLowerSideIsItsMirrorImage() {
        QCOMPARE(textOf(maskOver(face(false), drawn(0, 1e6), {{400e3, 600e3}})),
                 (QStringList{"400-600/400-600@-47.5--35", "0-400/0-400@-25-0", "400-400/375-400@-47.5--25",
                              "600-1000/600-1000@-25-0", "600-600/600-625@-47.5--25"}));
    }

    void shouldersMeetInTheMiddleOfASpacing() {
        const auto pieces = maskOver(face(true), drawn(0, 140e3), {{0, 50e3}, {90e3, 140e3}});
        QCOMPARE(textOf(pieces).mid(2),
                 (QStringList{"50-90/50-90@1000-1025", "50-70/50-50@1025-1047.5", "70-90/90-90@1025-1047.5"}));
    }

    void aMaskThatEndsOnCopperHasNoShoulderThere() {
        QCOMPARE(textOf(maskOver(face(true), drawn(500e3, 600e3), {{400e3, 600e3}})),
                 (QStringList{"500-600/500-600@1035-1047.5"}));
        QCOMPARE(textOf(maskOver(face(true), drawn(0, 600e3), {{10e3, 700e3}})).last(),
                 QString("0-10/10-10@1025-1047.5"));  // no more room than that
    }

    void thickMaskOverThinCopperIsLevel() {
        BoardFace thin = face(true);
        thin.copper = thin.substrate + 10'000;
        QCOMPARE(textOf(maskOver(thin, drawn(0, 1e6), {{400e3, 600e3}})),
                 (QStringList{"400-600/400-600@1010-1025", "0-400/0-400@1000-1025", "600-1000/600-1000@1000-1025"}));
    }

    void flatItFillsAllUpToItsOuterFace() {
        QCOMPARE(textOf(maskOver(face(true, true), drawn(0, 1e6), {{400e3, 600e3}})),
                 (QStringList{"400-600/400-600@1035-1060", "0-400/0-400@1000-1060", "600-1000/600-1000@1000-1060"}));
    }

    void inkLiesOnWhateverIsUnderIt() {
        const BoardFace top = face(true);
        QCOMPARE(textOf(inkOver(top, drawn(0, 1e6, 15'000), {{400e3, 600e3}, {900e3, 1e6}}, {{100e3, 800e3}})),
                 (QStringList{"400-600/400-600@1047.5-1062.5", "100-375/100-375@1025-1040", "625-800/625-800@1025-1040",
                              "900-1000/900-1000@1035-1050", "0-100/0-100@1000-1015", "800-900/800-900@1000-1015"}));
    }
};

QTEST_APPLESS_MAIN(MaskShapeTest)
#include "mask_shape_test.moc"
