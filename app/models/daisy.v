angle increment: 45
initial line width: 0.3
initial color: 1
tropism direction: 0,1,0
initial elasticity: 0.05
tropism: T: 0.25,0.15,1 E: 0
material: 1 stem kind=stem color=0.33,0.48,0.19 roughness=0.6
material: 2 leaf kind=leaf color=0.24,0.42,0.15 roughness=0.5 translucency=0.45
material: 3 petal kind=petal color=0.97,0.96,0.93 roughness=0.6 translucency=0.4
material: 4 disc kind=solid color=0.95,0.72,0.10 roughness=0.85
material: 5 bract kind=solid color=0.36,0.47,0.22 roughness=0.7
organ: r rosette kind=blade material=2 length=10 width=2.5 petiole=3 widest=0.7 tip=0.2 base=0.9 lobes=0.38 lobe_count=5 fold=14 curl=50
organ: l leaf kind=blade material=2 length=6 width=1.9 petiole=0 widest=0.6 tip=0.6 base=0.4 lobes=0.35 lobe_count=5 fold=18 curl=45
organ: p petal kind=blade material=3 length=2.8 width=0.84 petiole=0 widest=0.6 tip=0.1 base=0.6 fold=7 curl=22
organ: d disc kind=disc material=4 length=0.6 width=1.6
organ: c cup kind=ball material=5 length=0.75 width=1.3
calendar: p opens=4.6 grown=5.2 turns=9 bare=10.4
calendar: d opens=4.6 grown=5.2 turns=9 bare=10.4
calendar: c opens=4.6 grown=5.2 turns=9 bare=10.4
