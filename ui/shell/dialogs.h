#pragma once

#include <QString>
#include <functional>

class QWidget;

/// Questions to the user. None of them blocks: the answer comes by the callback, or never if the dialog is closed.
namespace ui {

using PathResult = std::function<void(const QString&)>;

enum class BoardForm { File, Folder };

void requestBoard(QWidget& parent, BoardForm form, const QString& startFolder, const PathResult& answer);
void requestPicturePath(QWidget& parent, const QString& startFolder, const PathResult& answer);
/// How wide a picture is to be, in pixels; `width` is proposed, `most` the limit.
void requestWidth(QWidget& parent, int width, int most, const std::function<void(int)>& answer);
void requestTablePath(QWidget& parent, const QString& startFolder, const PathResult& answer);
void requestStackupPath(QWidget& parent, const QString& startFolder, const PathResult& answer);
void requestSectionPath(QWidget& parent, const QString& startFolder, const PathResult& answer);
void requestRulesToOpen(QWidget& parent, const QString& startFolder, const PathResult& answer);
/// Text, a table or JSON, by the ending.
void requestReportPath(QWidget& parent, const QString& startFolder, const PathResult& answer);
void requestRulesPath(QWidget& parent, const QString& startFolder, const PathResult& answer);
void confirmReset(QWidget& parent, const std::function<void()>& confirmed);

}  // namespace ui
