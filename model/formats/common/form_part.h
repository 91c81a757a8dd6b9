#pragma once

#include <string>

namespace model::formats {

/// A board that a folder or archive holds in one format.
struct FormPart {
    std::string member;    ///< the file that is all of it; empty: the folder or archive as a whole
    std::string contents;  ///< for people, in a few words: "9 images, 2 drill files"
    bool isEmpty = false;  ///< a board with nothing on it: any other form says more
};

}  // namespace model::formats
