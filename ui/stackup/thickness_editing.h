#pragma once

#include <QObject>
#include <QUndoStack>
#include <memory>

#include "ui/workspace/loader.h"

namespace ui {

/// The user's thicknesses while a board is shown: edits that can be undone and redone, each worked into a document with
/// other heights and kept in the session file beside the job, which itself is never written to. Thicknesses that were
/// given for one time only (LoadRequest::thicknesses) stay out of the file until the user edits them.
class ThicknessEditing : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Forgets the history.
    void setBoard(const LoadedBoard& board);
    /// One step of the history, however many rows. A thickness of 0 takes a row back to what the job says.
    void set(const std::vector<model::ThicknessOverride>& changes);
    [[nodiscard]] QUndoStack& history() { return m_history; }
    /// The request that reads the board again as it is now: with what stands in no file.
    [[nodiscard]] LoadRequest request() const;

signals:
    /// The same board with other heights and messages; elements and ids are what they were.
    void restacked(const std::shared_ptr<const model::Document>& document);
    void notSaved(const QString& reason);

private:
    void apply(const SetThicknesses& state);
    void save();

    LoadRequest m_request;
    std::shared_ptr<const model::Document> m_document;
    SetThicknesses m_state;
    bool m_isSaved = true;
    QUndoStack m_history;
};

}  // namespace ui
