#include <QtTest>

#include "model/formats/gerber/naming/drill_spans.h"
#include "model/formats/gerber/naming/file_role.h"

using Kind = model::gerber::FileRole::Kind;
using Side = model::LayerSide;

Q_DECLARE_METATYPE(model::gerber::FileRole::Kind)
Q_DECLARE_METATYPE(model::LayerSide)

class GerberNamingTest : public QObject {
    Q_OBJECT

private slots:
    void functionsAreReadInBothSpellings() {
        const auto copper = model::gerber::roleOfFunction("Copper,L3,Inr");
        QVERIFY(copper && copper->kind == Kind::Copper && copper->order == 3 && copper->side == Side::Inner);
        for (const char* mask : {"Soldermask,Bot", "SolderMask,Bot"}) {
            const auto role = model::gerber::roleOfFunction(mask);
            QVERIFY(role && role->kind == Kind::SolderMask && role->side == Side::Bottom);
        }
        const auto drill = model::gerber::roleOfFunction("NonPlated,1,4,NPTH,Drill");
        QVERIFY(drill && drill->plating == model::Plating::NonPlated && drill->spanTop == 1 && drill->spanBottom == 4);
        QVERIFY(model::gerber::roleOfFunction("Profile,NP")->kind == Kind::Profile);
        QVERIFY(!model::gerber::roleOfFunction("").has_value());
    }

    void namesOfCadSystemsTellTheLayer_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<Kind>("kind");
        QTest::addColumn<Side>("side");
        QTest::addColumn<int>("order");
        QTest::newRow("Protel top") << "x.GTL" << Kind::Copper << Side::Top << 0;
        QTest::newRow("Altium inner") << "x.G12" << Kind::Copper << Side::Inner << 12;
        QTest::newRow("Altium plane") << "x.GP1" << Kind::Copper << Side::Inner << 1;
        QTest::newRow("Altium drawing") << "x.GM15" << Kind::Document << Side::None << 0;
        QTest::newRow("KiCad inner") << "b-In2_Cu.gbr" << Kind::Copper << Side::Inner << 2;
        QTest::newRow("KiCad outline") << "b-Edge_Cuts.gbr" << Kind::Profile << Side::None << 0;
        QTest::newRow("KiCad front") << "b-F_Cu.gbr" << Kind::Copper << Side::Top << 0;
        QTest::newRow("KiCad back mask") << "b-B_Mask.gbr" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("Eagle") << "soldermask_bottom.gbr" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("Eagle paste") << "solderpaste_top.gbr" << Kind::Paste << Side::Top << 0;
        QTest::newRow("old Eagle") << "board.sol" << Kind::Copper << Side::Bottom << 0;
        QTest::newRow("gEDA") << "board.bottommask.gbr" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("DipTrace") << "mainboard_TopSilk.gbr" << Kind::Legend << Side::Top << 0;
        QTest::newRow("PADS") << "SMB.pho" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("PADS inner") << "Layer3.pho" << Kind::Copper << Side::Inner << 3;
        QTest::newRow("Xpedition") << "EtchLayerBottom.gdo" << Kind::Copper << Side::Bottom << 0;
        QTest::newRow("Xpedition paste") << "SolderPasteTop.gdo" << Kind::Paste << Side::Top << 0;
        QTest::newRow("Xpedition drawing") << "DrillDrawingThrough.gdo" << Kind::Document << Side::None << 0;
        QTest::newRow("Allegro") << "l4_secondary.art" << Kind::Copper << Side::Bottom << 4;
        QTest::newRow("Allegro mask") << "b_smc_gaf.art" << Kind::SolderMask << Side::Top << 0;
        QTest::newRow("Allegro paste") << "b_sps.art" << Kind::Paste << Side::Bottom << 0;
        QTest::newRow("Allegro silkscreen") << "b_tslk_gaf.art" << Kind::Legend << Side::Top << 0;
        QTest::newRow("OrCAD silkscreen") << "SSTOP.art" << Kind::Legend << Side::Top << 0;
        QTest::newRow("Allegro mask by side") << "ctl_smbot.art" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("Allegro paste by side") << "SPTOP.art" << Kind::Paste << Side::Top << 0;
        QTest::newRow("Allegro assembly") << "ASTOP.art" << Kind::Document << Side::Top << 0;
        QTest::newRow("mask, primary side") << "SMPR.gbr" << Kind::SolderMask << Side::Top << 0;
        QTest::newRow("silkscreen, secondary side") << "b-slse.gbr" << Kind::Legend << Side::Bottom << 0;
        QTest::newRow("no assembly of the back") << "chasse_top.gbr" << Kind::Copper << Side::Top << 0;
        QTest::newRow("Target mask") << "b1.2.StopBot" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("Eagle's word for a mask") << "b_bottom_stop.gbr" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("Target silkscreen") << "b1.2.PosiTop" << Kind::Legend << Side::Top << 0;
        QTest::newRow("Target outline") << "b1.2.Outline" << Kind::Profile << Side::None << 0;
        QTest::newRow("Zuken") << "Conductive-3.fph" << Kind::Copper << Side::Inner << 3;
        QTest::newRow("Zuken paste") << "MetalMask-A.fph" << Kind::Paste << Side::Top << 0;
        QTest::newRow("Zuken mask") << "Resist-B.fph" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("pcb-rnd assembly") << "power-art.ast" << Kind::Document << Side::None << 0;
        QTest::newRow("Eagle inner") << "rambo.G2L" << Kind::Copper << Side::Inner << 2;
        QTest::newRow("Eagle inner with its number") << "x.G15L" << Kind::Copper << Side::Inner << 15;
        QTest::newRow("EasyEDA document") << "Gerber_DocumentLayer.GDL" << Kind::Document << Side::None << 0;
        QTest::newRow("Altium placement") << "Component Placement Top.GBR" << Kind::Document << Side::Top << 0;
        QTest::newRow("Altium profile") << "b.GM" << Kind::Profile << Side::None << 0;
        QTest::newRow("Altium bodies") << "x_Top_3D_Body.gbr" << Kind::Document << Side::Top << 0;
        QTest::newRow("Altium middles of parts")
            << "x_Bottom_Component_Center.gbr" << Kind::Document << Side::Bottom << 0;
        QTest::newRow("Altium drill map") << "x_Drillmap_1.gbr" << Kind::Document << Side::None << 0;
        QTest::newRow("Allegro room of parts") << "x_PLACE_BOUND_TOP.gbr" << Kind::Document << Side::Top << 0;
        QTest::newRow("Allegro legend of drills") << "x_NCLEGEND-1-6.gbr" << Kind::Document << Side::None << 0;
        QTest::newRow("Eagle paste") << "b.bcream.ger" << Kind::Paste << Side::Bottom << 0;
        QTest::newRow("Fritzing outline") << "x_contour.gbr" << Kind::Profile << Side::None << 0;
        QTest::newRow("DipTrace lengths") << "TopDimension.gbr" << Kind::Document << Side::Top << 0;
        QTest::newRow("PADS top") << "art001.pho" << Kind::Copper << Side::Top << 1;
        QTest::newRow("PADS copper, short") << "art0418.pho" << Kind::Copper << Side::Inner << 4;
        QTest::newRow("PADS plane") << "pgp002.pho" << Kind::Copper << Side::Inner << 2;
        QTest::newRow("a short bottom") << "Bot.gbr" << Kind::Copper << Side::Bottom << 0;
        QTest::newRow("mask on a short bottom") << "Bot_Mask.gbr" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("Eagle milling") << "b.MIL" << Kind::Profile << Side::None << 0;
        QTest::newRow("PADS film of a mask") << "sm002028.pho" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("PADS film of paste") << "smd001023.pho" << Kind::Paste << Side::Top << 0;
        QTest::newRow("PADS film of silkscreen") << "ssb002029.pho" << Kind::Legend << Side::Bottom << 0;
        QTest::newRow("PADS drawing") << "dd001024.pho" << Kind::Document << Side::None << 0;
        QTest::newRow("old KiCad front") << "radio-Front.pho" << Kind::Copper << Side::Top << 0;
        QTest::newRow("old KiCad component side") << "radio-Component.pho" << Kind::Copper << Side::Top << 0;
        QTest::newRow("old KiCad paste") << "radio-SoldP_Front.gbr" << Kind::Paste << Side::Top << 0;
        QTest::newRow("old KiCad mask") << "radio-MaskCop.pho" << Kind::SolderMask << Side::Bottom << 0;
        QTest::newRow("old KiCad silkscreen") << "radio-SilkS_Back.gbr" << Kind::Legend << Side::Bottom << 0;
        QTest::newRow("old KiCad outline") << "radio-PCB_Edges.gbr" << Kind::Profile << Side::None << 0;
        QTest::newRow("no bottom in CRAB_") << "crab_paste.gbr" << Kind::Paste << Side::None << 0;
        QTest::newRow("no routing in a router") << "router_b1.drd" << Kind::Drill << Side::Through << 0;
        QTest::newRow("fabrication") << "fab1.art" << Kind::Document << Side::None << 0;
    }
    void namesOfCadSystemsTellTheLayer() {
        QFETCH(QString, name);
        QFETCH(Kind, kind);
        QFETCH(Side, side);
        QFETCH(int, order);
        const auto role = model::gerber::roleOfName(name.toStdString());
        QVERIFY(role.has_value());
        QCOMPARE(static_cast<int>(role->kind), static_cast<int>(kind));
        QCOMPARE(static_cast<int>(role->side), static_cast<int>(side));
        QCOMPARE(role->order, order);
    }

    void namesOfDrillsTellThePlating() {
        QVERIFY(model::gerber::roleOfName("b-NPTH.drl")->plating == model::Plating::NonPlated);
        QVERIFY(model::gerber::roleOfName("b-PTH.drl")->plating == model::Plating::Plated);
        QVERIFY(model::gerber::roleOfName("b.unplated-drill.cnc")->plating == model::Plating::NonPlated);
        QVERIFY(model::gerber::roleOfName("b.xln")->plating == model::Plating::NotSaid);
        QVERIFY(model::gerber::roleOfName("pgp002.pho")->isNegative &&
                !model::gerber::roleOfName("art002.pho")->isNegative);
        QVERIFY(!model::gerber::roleOfName("notes.abc").has_value());
        QVERIFY(!model::gerber::roleOfName("feedback.gbr").has_value());
    }

    void namesOfDrillsTellTheirLayers() {
        using model::gerber::spanInName;
        QVERIFY((spanInName("board-1-6.drl") == model::gerber::NamedSpan{1, 6, false}));
        QVERIFY((spanInName("board_7-10.rou") == model::gerber::NamedSpan{7, 10, false}));
        QVERIFY((spanInName("board.drd.0215") == model::gerber::NamedSpan{2, 15, true}));
        for (const char* name : {"board.drl", "board-2.drl", "board-4-2.drl", "board.0117", "2021-3-4"}) {
            QVERIFY2(!spanInName(name), name);
        }
    }

    void boardsAreWhatNamesHaveInCommon_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("board");
        QTest::newRow("gEDA") << "driver.top.gbr"
                              << "DRIVER";
        QTest::newRow("gEDA drill") << "driver.plated-drill.cnc"
                                    << "DRIVER";
        QTest::newRow("DipTrace") << "mainboard_BoardOutline.gbr"
                                  << "MAINBOARD";
        QTest::newRow("DipTrace drill") << "mainboard.drl"
                                        << "MAINBOARD";
        QTest::newRow("KiCad") << "Flash-pads-Edge_Cuts.gbr"
                               << "FLASH-PADS";
        QTest::newRow("KiCad inner") << "watch.panel-In2_Cu.gbr"
                                     << "WATCH.PANEL";
        QTest::newRow("KiCad, of a revision") << "Lime_Rev_B1-F_Cu.gbr"
                                              << "LIME_REV_B1";
        QTest::newRow("Target") << "IoT1.2.StopTop"
                                << "IOT1.2";
        QTest::newRow("Altium") << "LimeSDR_1v2.GTL"
                                << "LIMESDR_1V2";
        QTest::newRow("nothing but a layer") << "Solder_Mask_Top.art"
                                             << "";
    }
    void boardsAreWhatNamesHaveInCommon() {
        QFETCH(QString, name);
        QFETCH(QString, board);
        QCOMPARE(QString::fromStdString(model::gerber::boardOfName(name.toStdString())), board);
    }

    void commentsTellTheLayer() {
        model::gerber::Image altium;
        altium.comments = {"Layer_Physical_Order=4"};
        QCOMPARE(model::gerber::roleOfComments(altium)->order, 4);
        model::gerber::Image allegro;
        allegro.comments = {"Layer:  VIA KEEPOUT/BOTTOM", "Layer:  VIA KEEPOUT/GND", "Layer:  VIA KEEPOUT/TOP",
                            "Layer:  PIN/GND", "Layer:  ETCH/GND"};
        const auto role = model::gerber::roleOfComments(allegro);
        QVERIFY(role && role->kind == Kind::Copper && role->side == Side::Inner);
        QCOMPARE(role->order, 2);
        QVERIFY(!role->isNegative);
        allegro.comments.emplace_back("Mode:      Negative");
        QVERIFY(model::gerber::roleOfComments(allegro)->isNegative);
        model::gerber::Image mask;
        mask.comments = {"Layer:  PIN/SOLDERMASK_TOP", "Layer:  BOARD GEOMETRY/SOLDERMASK_TOP"};
        QVERIFY(model::gerber::roleOfComments(mask)->kind == Kind::SolderMask);
        model::gerber::Image silkscreen;
        silkscreen.comments = {"Layer:  MANUFACTURING/AUTOSILK_BOTTOM", "Layer:  REF DES/SILKSCREEN_BOTTOM",
                               "Layer:  DRAWING FORMAT/TITLE_BLOCK"};
        const auto legend = model::gerber::roleOfComments(silkscreen);
        QVERIFY(legend && legend->kind == Kind::Legend && legend->side == Side::Bottom);
        QVERIFY(!model::gerber::roleOfComments({}).has_value());
    }

    /// Films of any layer have frames and labels; only those without anything of the board, or with tables of holes and
    /// layers, are drawings.
    void framesMakeNoDrawingOfAFilm() {
        const std::vector<std::string> frame = {"Layer:  DRAWING FORMAT/TITLE_BLOCK", "Layer:  DRAWING FORMAT/LABEL",
                                                "Layer:  BOARD GEOMETRY/OUTLINE"};
        model::gerber::Image drawing;
        drawing.comments = frame;
        QVERIFY(model::gerber::roleOfComments(drawing)->kind == Kind::Document);
        model::gerber::Image mask = drawing;
        mask.comments.emplace_back("Layer:  PIN/SOLDERMASK_BOTTOM");
        const auto role = model::gerber::roleOfComments(mask);
        QVERIFY(role && role->kind == Kind::SolderMask && role->side == Side::Bottom);
        model::gerber::Image fabrication = mask;
        fabrication.comments.emplace_back("Layer:  MANUFACTURING/NCLEGEND-1-4");
        QVERIFY(model::gerber::roleOfComments(fabrication)->kind == Kind::Document);
        model::gerber::Image holes;
        holes.comments = {"Layer:  MANUFACTURING/NCLEGEND-1-12", "Layer:  BOARD GEOMETRY/OUTLINE"};
        QVERIFY(model::gerber::roleOfComments(holes)->kind == Kind::Document);
    }

    /// OrCAD's silkscreen may show a class of the assembly drawing too, and assembly drawings silkscreen.
    void filmsAreWhatMostOfTheirClassesAre() {
        model::gerber::Image silkscreen;
        silkscreen.comments = {"Layer:  REF DES/SILKSCREEN_BOTTOM", "Layer:  PACKAGE GEOMETRY/ASSEMBLY_BOTTOM",
                               "Layer:  PACKAGE GEOMETRY/SILKSCREEN_BOTTOM", "Layer:  BOARD GEOMETRY/OUTLINE"};
        const auto legend = model::gerber::roleOfComments(silkscreen);
        QVERIFY(legend && legend->kind == Kind::Legend && legend->side == Side::Bottom);
        model::gerber::Image assembly;
        assembly.comments = {"Layer:  REF DES/ASSEMBLY_TOP", "Layer:  PACKAGE GEOMETRY/ASSEMBLY_TOP",
                             "Layer:  BOARD GEOMETRY/SILKSCREEN_TOP"};
        QVERIFY(model::gerber::roleOfComments(assembly)->kind == Kind::Document);
    }
};

QTEST_APPLESS_MAIN(GerberNamingTest)
#include "gerber_naming_test.moc"
