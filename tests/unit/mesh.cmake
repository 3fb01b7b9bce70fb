surpass_test(unit_mesh SOURCES mesh_diagnose_test.cpp mesh_repair_test.cpp mesh_select_test.cpp
             mesh_topology_test.cpp mesh_triangulate_test.cpp mesh_weld_test.cpp LABELS unit)
