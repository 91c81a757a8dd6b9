#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <optional>

#include "model/clearance/rule_file.h"
#include "ui/clearance/clearance_map_overlay.h"
#include "ui/clearance/clearance_panel.h"
#include "ui/clearance/clearance_search.h"
#include "ui/clearance/lens.h"
#include "ui/clearance/rule_waivers.h"
#include "ui/findings/shown_finding.h"
#include "ui/views/plan_painter.h"
#include "ui/views/probing.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/feature.h"

namespace ui {

/// What a search found, and how it was asked for.
struct ClearanceAnswer {
    ClearanceRequest request;
    std::shared_ptr<const model::Document> board;
    ClearanceResult result;
};

/// The smallest clearances of the copper, from the search to the location on the screen: searches in the background, a
/// panel to step through what was found, rules and waivers in the session, with their files and on the history, the
/// lens and the clearance map. Other thicknesses end what was found through the stackup. Waivers change what a check
/// found, so it is made anew. While a location is shown both views are there, and the layers of its two sides stand
/// out, whatever is checked and whatever covers them; all is as before once something else is selected, or nothing.
class ClearanceFeature : public QObject {
    Q_OBJECT

public:
    explicit ClearanceFeature(FeatureContext& context);

    /// What is listed, as the command line writes it, in the format of the name's ending (.txt, .csv,
    /// .json, of rules also .xml, .sarif, .html with drawings of the worst locations). Errors: BadUsage for another
    /// ending or without a search.
    [[nodiscard]] base::Result<std::string> report(const QString& path) const;
    /// Errors: BadInput; the rules are then what they were.
    [[nodiscard]] base::Result<QString> openRules(const QString& path);

signals:
    /// The rules are from another file: what nobody checks of it, for the list of messages.
    void rulesListed(const model::Diagnostics& messages);

private:
    void connectPanel(FeatureContext& context);
    void connectCommands(FeatureContext& context);
    void connectFiles(FeatureContext& context);
    void connectWaivers(FeatureContext& context);
    /// By rows of the list that was checked last; that of now may be shorter until it is checked anew.
    void withdraw(const std::vector<std::size_t>& rows);
    void setBoard(const LoadedBoard& board);
    /// Of the board with other heights; what is being searched ends, too.
    void endThroughStackup();
    /// Checks again what was checked last, with the waivers of now; the current row stays.
    void checkAnew();
    void run(ClearanceRequest request);
    [[nodiscard]] const std::optional<ClearanceAnswer>& answerOf(ClearancePanel::What what) const {
        return m_answers[static_cast<std::size_t>(what)];
    }
    [[nodiscard]] const std::optional<ClearanceAnswer>& answer() const { return answerOf(m_panel->what()); }
    [[nodiscard]] QStringList exportFilters() const;
    void setUnit(LengthUnit unit);
    /// Searches for what the panel requests.
    void search();
    /// Shows the next location of the table, or with -1 the one before.
    void step(int by);
    /// Opens a dialog; what is accepted counts.
    void editRules(QWidget& parent);
    /// None if there is nothing to search for; that was reported.
    [[nodiscard]] std::optional<ClearanceRequest> request();
    [[nodiscard]] std::optional<ClearanceRequest> throughStackup(ClearanceRequest request);
    void reportNoTwoNets();
    void take();
    /// Lists what was found of the kind that the panel asks for: rows of another question would read as an answer.
    void list();
    void listAnswer();
    [[nodiscard]] QString notes() const;
    /// Until something else is selected.
    void show(const ClearanceModel::Location& location);
    void showPlain(const ClearanceModel::Location& location);
    void showThrough(const model::StackupClearance& found);
    void showSides(std::vector<model::BoardElement> sides, std::vector<model::LayerId> layers,
                   const ShownSpacing& spacing);
    void setRules(const model::RuleFile& rules);
    /// Other rules, but from the same file.
    [[nodiscard]] model::RuleFile withTable(const model::RuleTable& table) const;
    /// The row from before a check; where it was waived and so moved, the one that took its place.
    void restoreCurrent();
    /// Puts on the history that the rules are others than before.
    void remember(const model::RuleTable& before);
    [[nodiscard]] model::LayerId mappedLayer() const;
    [[nodiscard]] QStringList ruleLayers() const;

    Workspace& m_workspace;
    BoardViews& m_views;
    Probing& m_probing;
    SelectionModel& m_selection;
    ShownFinding m_shown;
    const PlanPainter& m_plan;
    ClearanceModel m_locations;
    RuleModel m_rules;
    SessionPart<model::RuleFile, std::optional<model::RuleTable>> m_savedRules;
    model::RuleFile m_ruleFile;  ///< where the rules are from; its table is as they were taken or shown last
    RuleWaivers m_waivers;
    BackgroundResult<ClearanceResult> m_search;
    std::shared_ptr<const model::Document> m_searched;  ///< the board that is or was searched, and what for
    ClearanceRequest m_wanted;
    Lens m_lens;
    ClearanceMapOverlay m_distances;
    ClearancePanel* m_panel;
    std::array<std::optional<ClearanceAnswer>, 3> m_answers;  ///< the last ones, by ClearancePanel::What
    bool m_isThroughStale = false;  ///< what was found through the stackup was that of other heights, and is gone
    std::optional<ClearanceModel::Location> m_current;  ///< to be the current row again after a check
    ClearancePanel::Place m_place;                      ///< where it was
};

}  // namespace ui
