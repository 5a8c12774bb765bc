angle increment: 45
initial line width: 0.4
initial color: 1
tropism direction: 0,1,0
material: 1 stem kind=stem color=0.42,0.50,0.22 roughness=0.7
material: 2 leaf kind=leaf color=0.26,0.46,0.16 roughness=0.5 translucency=0.45
material: 3 cane kind=bark color=0.60,0.48,0.28 roughness=0.8
material: 4 corolla kind=petal color=0.36,0.34,0.86 roughness=0.5 translucency=0.5
material: 5 throat kind=solid color=0.97,0.95,0.85 roughness=0.6
organ: l leaf kind=blade material=2 length=9.5 width=8.8 petiole=0.4 widest=0.2 tip=1.4 base=0.3 fold=10 curl=32
organ: p lobe kind=blade material=4 length=6.2 width=5.4 petiole=0 widest=0.82 tip=0.25 base=1.3 fold=-16 curl=62
organ: t throat kind=ball material=5 length=0.9 width=0.7
calendar: p opens=5.8 grown=6.4 turns=9 bare=10.2
calendar: t opens=5.8 grown=6.4 turns=9 bare=10.2
