#include "model/agreement/stackup_agreement.h"

#include <QtTest>

#include "tests/unit/model/formats/drawing/drawn_testing.h"

using namespace drawn_testing;
using model::Accord;
using model::Comparison;

namespace {

/// Two copper layers with a mask over them. 0: the job does not say.
DrawnJob board(double topNm, double coreNm, double bottomNm, double boardNm = 0.0) {
    DrawnJob job = boardOfTwoLayers();
    addLayer(job, "MASK", LayerType::SolderMask);
    std::rotate(job.layers.begin(), job.layers.end() - 1, job.layers.end());
    const auto stated = [](double nm) { return nm > 0.0 ? std::optional(nm) : std::nullopt; };
    job.layers[0].facts.thicknessNm = 20e3;
    job.layers[1].facts.thicknessNm = stated(topNm);
    job.layers[1].facts.belowNm = stated(coreNm);
    job.layers[2].facts.thicknessNm = stated(bottomNm);
    job.boardNm = stated(boardNm);
    return job;
}

Comparison compared(const DrawnJob& a, const DrawnJob& b) {
    return compareStackups(*assembled(a), *assembled(b), {});
}

std::vector<std::string> textsOf(const Comparison& comparison) {
    std::vector<std::string> texts;
    for (const model::Difference& difference : comparison.differences) {
        texts.push_back(difference.text);
    }
    return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

class StackupAgreementTest : public QObject {
    Q_OBJECT

private slots:
    void thicknessesThatAreStatedAlikeAgree() {
        const Comparison found = compared(board(35e3, 1.51e6, 35e3), board(35.56e3, 1.5113e6, 34.8e3));
        QCOMPARE(found.accord, Accord::Agree);
        QCOMPARE(found.counts, (std::array<std::size_t, 2>{2, 2}));
        QVERIFY(found.note.empty());
    }

    void aThickerLayerIsNamedAndSoIsTheBoard() {
        const Comparison copper = compared(board(35e3, 1.51e6, 35e3), board(70e3, 1.51e6, 35e3));
        QCOMPARE(copper.accord, Accord::Differ);
        QCOMPARE(textsOf(copper), (Texts{"copper TOP is 35.0 µm thick in A, 70.0 µm in B",
                                         "the board is 1580.0 µm thick in A, 1615.0 µm in B"}));
        const Comparison dielectric = compared(board(35e3, 1.51e6, 35e3), board(35e3, 1.5e6, 35e3));
        QCOMPARE(textsOf(dielectric).front(),
                 std::string("the dielectric below TOP is 1510.0 µm thick in A, 1500.0 µm in B"));
    }

    void pliesBetweenTwoCopperLayersAreOneThickness() {
        DrawnJob plies = board(35e3, 0.0, 35e3);
        for (const char* name : {"PREPREG", "CORE"}) {
            addLayer(plies, name, LayerType::Dielectric);
            plies.layers.back().facts.thicknessNm = 755e3;
            std::rotate(plies.layers.begin() + 2, plies.layers.end() - 1, plies.layers.end());
        }
        QCOMPARE(compared(board(35e3, 1.51e6, 35e3), plies).accord, Accord::Agree);
    }

    /// The dielectric's share of the board is no number of the job.
    void whatIsNotStatedIsNotCompared() {
        const Comparison shared = compared(board(35e3, 1.2e6, 35e3), board(35e3, 0.0, 35e3, 1.27e6));
        QCOMPARE(shared.accord, Accord::Agree);
        QCOMPARE(shared.note, std::string("1 of 4 thicknesses only one job states, or none"));
        const Comparison nothing = compared(board(35e3, 1.51e6, 35e3), board(0.0, 0.0, 0.0));
        QCOMPARE(nothing.accord, Accord::NotCompared);
        QCOMPARE(nothing.note, std::string("4 of 4 thicknesses only one job states, or none"));
    }

    /// The mask of this job is 20 µm thick.
    void aBoardMayCountItsSolderMask() {
        QCOMPARE(compared(board(35e3, 1.51e6, 35e3), board(0.0, 0.0, 0.0, 1.6e6)).accord, Accord::Agree);
        const Comparison found = compared(board(35e3, 1.51e6, 35e3), board(0.0, 0.0, 0.0, 1.8e6));
        QCOMPARE(textsOf(found), Texts{"the board is 1580.0 µm thick in A, 1800.0 µm in B"});
    }

    void ofOtherNumbersOfCopperLayersTheBoardAloneIsCompared() {
        DrawnJob more = board(35e3, 700e3, 35e3, 1.58e6);
        addLayer(more, "INNER", LayerType::Signal);
        std::rotate(more.layers.begin() + 2, more.layers.end() - 1, more.layers.end());
        const Comparison found = compared(board(35e3, 1.51e6, 35e3), more);
        QCOMPARE(found.accord, Accord::Agree);
        QCOMPARE(found.counts, (std::array<std::size_t, 2>{2, 3}));
        QVERIFY(found.note.find("the board alone") == 0);
    }

    void aBoardWithoutCopperHasNoStackup() {
        DrawnJob bare = boardOfTwoLayers();
        bare.layers.clear();
        addLayer(bare, "PRINT", LayerType::SilkScreen);
        const Comparison found = compared(board(35e3, 1.51e6, 35e3), bare);
        QCOMPARE(found.accord, Accord::NotCompared);
        QCOMPARE(found.note, std::string("B has no stackup"));
    }
};

QTEST_APPLESS_MAIN(StackupAgreementTest)
#include "stackup_agreement_test.moc"
