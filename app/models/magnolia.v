angle increment: 45
initial line width: 1
initial color: 1
tropism direction: 0,1,0
initial elasticity: 0.06
radii: pipe 2.1 0.28
material: 1 bark kind=bark bark=beech color=0.48,0.45,0.41 roughness=1
material: 2 leaf kind=leaf color=0.40,0.53,0.20 roughness=0.45 translucency=0.45
material: 3 tepal kind=petal color=0.90,0.62,0.74 roughness=0.5 translucency=0.5
material: 4 cone kind=solid color=0.55,0.55,0.25 roughness=0.7
organ: l leaf kind=blade material=2 length=14 width=6.5 petiole=1.5 widest=0.6 tip=0.5 base=0.7 fold=20 curl=20
organ: p tepal kind=blade material=3 length=9 width=4.6 petiole=0 widest=0.6 tip=0.3 base=0.6 fold=40 curl=-48
organ: c cone kind=ball material=4 length=2.6 width=1.1
leaf: l magnolia
calendar: l opens=4.4 grown=5.9 turns=9.4 bare=11.5
calendar: p opens=3.4 grown=3.9 turns=4.7 bare=5.2
