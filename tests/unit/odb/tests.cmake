# Tests of the ODB++ reader; see docs/testing.md. They link what the reader links, because they write archives themselves.
foreach(name zones message_locations records archive features job_files eda parts standard_symbols swept_tracks text painting feature_attributes parse_memory reader panel_reader stackup_xml layer_facts holes stackup boards)
    copperscope_test(odb_${name}_test unit/odb/${name}_test.cpp LABEL unit LINK copperscope_model)
endforeach()
