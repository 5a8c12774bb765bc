angle increment: 45
initial line width: 0.5
initial color: 1
tropism direction: 0,1,0
initial elasticity: 0.035
radii: pipe 2.3 0.1
material: 1 bark kind=bark color=0.38,0.31,0.25 roughness=0.9
material: 2 leaf kind=leaf color=0.33,0.45,0.19 roughness=0.5 translucency=0.4
material: 3 berry kind=solid color=0.72,0.10,0.08 roughness=0.3
organ: l leaf kind=blade material=2 length=4.2 width=2.2 petiole=0 widest=0.5 tip=0.6 base=0.5 fold=18 curl=25
organ: b berry kind=ball material=3 length=0.95 width=0.95
calendar: b opens=7 grown=8.5 turns=11 bare=12.8
