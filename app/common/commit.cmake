# Writes OUT with the commit of SOURCE, and leaves it alone when nothing changed, so that nothing is compiled again.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty=+ --exclude=*
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT
    "#include \"app/common/commit.h\"\n\nnamespace app {\nconst char* const kCommit = \"@commit@\";\n}\n")
