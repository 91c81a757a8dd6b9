# Item models over hand-made documents; no window, no device.
copperscope_test(uimodels_layer_model unit/uimodels/layer_model_test.cpp LABEL unit LINK copperscope_ui_models)
copperscope_test(uimodels_message_model unit/uimodels/message_model_test.cpp LABEL unit LINK copperscope_ui_models)
copperscope_test(uimodels_statistics_model unit/uimodels/statistics_model_test.cpp LABEL unit LINK copperscope_ui_models)
copperscope_test(uimodels_element_facts unit/uimodels/element_facts_test.cpp LABEL unit LINK copperscope_ui_models)
copperscope_test(uimodels_selection_model unit/uimodels/selection_model_test.cpp LABEL unit LINK copperscope_ui_models)
copperscope_test(uimodels_net_model unit/uimodels/net_model_test.cpp LABEL unit LINK copperscope_ui_models)
copperscope_test(uimodels_stack_model unit/uimodels/stack_model_test.cpp LABEL unit LINK copperscope_ui_models)
copperscope_test(uimodels_board_search unit/uimodels/board_search_test.cpp LABEL unit LINK copperscope_ui_models copperscope_odb LibArchive::LibArchive)
