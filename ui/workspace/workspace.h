#pragma once

#include <QPointer>
#include <QUndoStack>
#include <functional>
#include <optional>

#include "model/geometry/edges.h"
#include "ui/common/display_units.h"
#include "ui/workspace/loader.h"
#include "ui/workspace/selection_model.h"
#include "ui/workspace/writing_thread.h"

namespace ui {

/// A spacing on the board that the views are to draw, from element to element; these may be none.
struct ShownSpacing {
    model::Spacing spacing;  ///< nm of the board; its ends as seen from above
    model::BoardElement from;
    model::BoardElement to;
    model::LayerId fromLayer;  ///< of the board
    model::LayerId toLayer;
    double height = 0.0;  ///< nm between their faces; 0: on one layer, or beside a hole
};

/// What is open and what is being done with it: the board, the unit, the selection, the undo history, messages to the
/// user and work in the background. Panels, tools and views listen to it and do not know each other.
///
/// A board is opened in four steps; everybody has taken the board in one before the next begins, so nobody hears of a
/// board before what it stands on has it: `boardRead`, `boardShown`, then the selection is emptied, `boardOpened`,
/// `sessionRestored`. Within a step the order does not matter. Before the first, whoever keeps something of the board
/// on the screen hears `boardLeaves`.
class Workspace : public QObject {
    Q_OBJECT

public:
    /// `work` is what loads boards; tests put their own in.
    explicit Workspace(Loader::Work work = loadBoard, QObject* parent = nullptr);

    /// Null before the first board. The one on the screen stays until the next one is read, and if that fails.
    [[nodiscard]] const LoadedBoard* board() const { return m_board ? &*m_board : nullptr; }
    /// Where the board lies, to put files beside it; the home folder without a board, or where nothing can be written.
    [[nodiscard]] QString boardFolder() const;
    /// Is this the step on the screen?
    [[nodiscard]] bool isOpen(const std::string& step) const { return m_board && m_board->document->job.step == step; }
    /// Stops all work but the writing of files, and reads a board in the background.
    void open(model::OpenRequest request);
    /// Opens the board again, after `change` of the request. Its thicknesses stay as they are, in a file or not.
    void reload(const std::function<void(model::OpenRequest&)>& change = {});
    /// Other thicknesses of the open board, worked into `document`; elements and ids are what they were.
    void restack(std::shared_ptr<const model::Document> document, model::SetThicknesses thicknesses, bool areSaved);

    [[nodiscard]] LengthUnit unit() const { return m_unit; }
    void setUnit(LengthUnit unit);
    [[nodiscard]] SelectionModel& selection() { return m_selection; }
    [[nodiscard]] QUndoStack& history() { return m_history; }
    /// What the user saves of the board or sets for it is written here. Boards are read when all is written.
    [[nodiscard]] WritingThread& files() { return m_files; }
    /// The one that the cursor of the layers panel is on; none if there is none.
    [[nodiscard]] model::LayerId currentLayer() const { return m_currentLayer; }
    void setCurrentLayer(model::LayerId layer);

    /// For the status line.
    void report(const QString& text) { emit reported(text, false); }
    void report(const std::string& text) { report(QString::fromStdString(text)); }
    void prompt(const QString& text) { emit reported(text, true); }
    /// For the message bar, where it stays.
    void reportError(const QString& text) { emit errorReported(text); }
    /// For the list of messages, after those that the board came with: what is not in the file that was exported last.
    void listExported(const model::Diagnostics& messages) { emit exportListed(messages); }
    /// "Saved /home/me/stackup.svg", or why not.
    void reportSaved(const base::Status& saved, const QString& path);

    /// Shows the progress of this work from now on, and lets Esc stop it. It is about the board: another one stops it.
    void watch(Background& work, std::function<QString()> name) { watch(work, std::move(name), {}); }
    /// The same of work that writes a file of that name, which goes on while another board is opened.
    void watchWriting(Background& work, const std::function<QString()>& name) { watch(work, name, name); }
    /// Likewise; `file` says what is written now or next, empty: nothing that would be missed if the work were stopped.
    void watchWriting(Background& work, std::function<QString()> name, std::function<QString()> file) {
        watch(work, std::move(name), std::move(file));
    }
    /// Stops what runs, a load first; false when nothing does.
    bool cancelWork();
    void cancelLoading() { m_loader.cancel(); }
    [[nodiscard]] bool isWorking() const { return firstRunning() != nullptr; }
    /// The name of the file that is being written; empty for none.
    [[nodiscard]] QString fileAtWork() const;

    /// Requests to whoever shows the board: makes the layer visible, brings elements or a location (nm of the board) to
    /// the middle of the views, draws a spacing in them (none: no longer).
    void showLayer(model::LayerId layer) { emit layerWanted(layer); }
    void showElements(const std::vector<model::BoardElement>& elements) { emit elementsWanted(elements); }
    void showNets(const std::vector<model::BoardNet>& nets) { showElements(m_selection.elementsOf(nets)); }
    void showSpacing(const std::optional<ShownSpacing>& spacing) { emit spacingWanted(spacing); }
    void showLocation(base::PointD nm, model::LayerId layer) { emit locationWanted(nm, layer); }

signals:
    void openingBegan(const model::OpenRequest& request);
    /// There are several forms to choose from, the proposed one first; one of them is to be opened (requestOf).
    void formsFound(const model::OpenRequest& request, const std::vector<model::BoardForm>& forms);
    /// Another board, or the same one anew, is about to take the place of the one on the screen.
    void boardLeaves(const ui::LoadedBoard& next);
    void boardRead(const ui::LoadedBoard& board);        ///< 1: item models; the selection is of the board before
    void boardShown(const ui::LoadedBoard& board);       ///< 2: the views, and what picks in them
    void boardOpened(const ui::LoadedBoard& board);      ///< 3: panels, tools, overlays; the selection is of this board
    void sessionRestored(const ui::LoadedBoard& board);  ///< 4: what the session puts into all of them
    /// The same board with other heights and messages.
    void restacked(const ui::LoadedBoard& board);
    void unitChanged(ui::LengthUnit unit);
    void currentLayerChanged(model::LayerId layer);

    /// `isStanding`: it holds until something else is said (Hint); else it is of what was just done.
    void reported(const QString& text, bool isStanding);
    void errorReported(const QString& text);
    void exportListed(const model::Diagnostics& messages);

    void workBegan(const QString& name);
    void workProgressed(const QString& phase, double fraction);
    /// No work is left.
    void idle();

    /// The graphics device failed and is about to be renewed: who made something from it gives that up.
    void deviceGoes();
    void layerWanted(model::LayerId layer);
    void elementsWanted(const std::vector<model::BoardElement>& elements);
    void spacingWanted(const std::optional<ui::ShownSpacing>& spacing);
    void locationWanted(base::PointD nm, model::LayerId layer);

private:
    struct Work {
        QPointer<Background> background;
        std::function<QString()> name;
        std::function<QString()> file;  ///< none: it does not write, and is about the board
    };
    /// Thicknesses that are not those of the board that was read.
    struct Restack {
        model::SetThicknesses thicknesses;
        bool areSaved = true;
    };

    [[nodiscard]] Loader::Work afterWriting(Loader::Work work);
    void watch(Background& work, std::function<QString()> name, std::function<QString()> file);
    void onEnded();
    void stopWorkOnBoard();
    void take(const LoadedBoard& board);
    [[nodiscard]] std::optional<Restack> laterThicknesses(const LoadedBoard& next) const;
    [[nodiscard]] const Work* firstRunning() const;

    std::optional<LoadedBoard> m_board;
    Background m_freeing;  ///< of the board before: its indexes take longer than a frame
    LengthUnit m_unit = LengthUnit::Millimetre;
    model::LayerId m_currentLayer;
    SelectionModel m_selection;
    QUndoStack m_history;
    std::vector<Work> m_works;                              ///< watched, loading first
    std::optional<model::SetThicknesses> m_asOpeningBegan;  ///< of the board on the screen
    WritingThread m_files;
    Loader m_loader;
};

}  // namespace ui
