import gmsh, sys, struct, numpy as np
gmsh.initialize(); gmsh.option.setNumber("General.Terminal",0)
m=gmsh.model; g=m.geo
pts=[(0,0),(1,0),(2,0),(2,1),(1,1),(0,1),(.4,.4),(.6,.4),(.5,.6)]
P=[g.addPoint(x,y,0,.6) for x,y in pts]
L=[g.addLine(P[a],P[b]) for a,b in [(0,1),(1,2),(2,3),(3,4),(4,5),(5,0),(1,4),(6,7),(7,8),(8,6)]]
cl1=g.addCurveLoop([L[0],L[6],L[4],L[5]]); clh=g.addCurveLoop([L[7],L[8],L[9]])
cl2=g.addCurveLoop([L[1],L[2],L[3],-L[6]])
s1=g.addPlaneSurface([cl1,clh]); s2=g.addPlaneSurface([cl2]); g.synchronize()
m.addPhysicalGroup(0,[P[3]],4,"corner")
m.addPhysicalGroup(1,[L[0],L[1],L[3],L[4]],1,"wall")
m.addPhysicalGroup(1,[L[5]],2,"in flow")
m.addPhysicalGroup(1,[L[2]],3,"outlet")
m.addPhysicalGroup(1,[L[6]],7,"interface wall")
m.addPhysicalGroup(1,[L[7],L[8],L[9]],9,"pillar")
m.addPhysicalGroup(2,[s1],11,"water"); m.addPhysicalGroup(2,[s2],12,"Stein ß")
gmsh.option.setNumber("Mesh.MeshSizeMax",1.0)
m.mesh.generate(2)
o=gmsh.option.setNumber
for v in (2.2,4.1):
  for b in (0,1):
    o("Mesh.MshFileVersion",v); o("Mesh.Binary",b); gmsh.write(f"gmsh_{str(v).replace('.','')}_{'binary' if b else 'ascii'}.msh")
o("Mesh.Binary",0)
for e in ("vtk","mesh","su2","inp"): gmsh.write("gmsh."+e)
o("Mesh.Binary",1); gmsh.write("gmsh_binary.vtk")
nt=m.mesh.getElements(2)
tags=np.concatenate(nt[1]); nodes=m.mesh.getNodes()[0]
v1=gmsh.view.add("load"); gmsh.view.addHomogeneousModelData(v1,0,m.getCurrent(),"ElementData",tags,[float(i)+.5 for i in range(len(tags))])
v2=gmsh.view.add("speed"); gmsh.view.addHomogeneousModelData(v2,0,m.getCurrent(),"NodeData",nodes,[x for i in range(len(nodes)) for x in (float(i),.25,0)],numComponents=3)
for v in (2.2,4.1):
  for b in (0,1):
    n=f"data_{str(v).replace('.','')}_{'binary' if b else 'ascii'}.msh"
    o("Mesh.MshFileVersion",v); o("Mesh.Binary",b); o("PostProcessing.SaveMesh",1); gmsh.view.write(v1,n); o("PostProcessing.SaveMesh",0); gmsh.view.write(v2,n,True)
m.mesh.setOrder(2)
for v in (2.2,4.1):
  for b in (0,1):
    o("Mesh.MshFileVersion",v); o("Mesh.Binary",b); gmsh.write(f"order2_{str(v).replace('.','')}_{'binary' if b else 'ascii'}.msh")
o("Mesh.Binary",0); gmsh.write("order2.vtk"); gmsh.write("order2.mesh"); gmsh.write("order2.inp")
gmsh.finalize()
